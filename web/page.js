// The page: takes a text, hands it to a worker that runs the program, shows the page that comes back.
const SECONDS = 30, LARGEST = 2_000_000, QUIET = 700;
const byId = id => document.getElementById(id);
const text = byId("text"), found = byId("found"), state = byId("state"), stop = byId("stop");

const EXAMPLES = /*EXAMPLES*/[];

/** The bytes of a text in base64. */
const bytesOf = base64 => Uint8Array.from(atob(base64), c => c.charCodeAt(0));
/** Bytes through a stream that packs or unpacks. */
const through = async (bytes, stream) => new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());

const say = (words, bad = false) => { state.textContent = words; state.className = bad ? "bad" : ""; };

const tooLong = length => say(`The text has ${length} characters; ${LARGEST} are taken.`, true);

let program, worker, asked = 0, clock;

/** A worker that knows the program; the one before is thrown away with what it is at. */
function fresh() {
  worker?.terminate();
  worker = new Worker(URL.createObjectURL(new Blob([byId("worker").textContent], { type: "text/javascript" })));
  worker.onmessage = ({ data }) => data.asked === asked && shown(data);
  worker.onerror = e => { ended(); say(`The program ended: ${e.message || "it could not go on"}`, true); fresh(); };
  worker.postMessage({ program });
}

function ended() { clearTimeout(clock); stop.hidden = true; }

/** A second worker is not asked while the first one works: it is thrown away. */
function check() {
  if (!program) return;
  const what = text.value;
  if (!what.trim()) { ended(); found.srcdoc = ""; return say("Nothing is written."); }
  if (what.length > LARGEST) return tooLong(what.length);
  if (!stop.hidden) fresh();
  ended();
  asked++;
  stop.hidden = false;
  say("Working …");
  clock = setTimeout(() => { ended(); fresh(); say(`Not done within ${SECONDS} seconds: nothing is said. A shorter text may be.`, true); }, SECONDS * 1000);
  worker.postMessage({ asked, text: what });
}

function shown({ page, problem, milliseconds }) {
  ended();
  if (problem) { say(problem, true); fresh(); return; }
  found.srcdoc = page;
  say(`Done in ${(milliseconds / 1000).toFixed(1)} s.`);
}

/** A text in the address of the page, packed. */
const packed = async what => btoa(String.fromCharCode(...await through(new TextEncoder().encode(what), new CompressionStream("deflate-raw")))).replace(/\+/g, "-").replace(/\//g, "_").replace(/=+$/, "");
const unpacked = async hash => new TextDecoder().decode(await through(bytesOf(hash.replace(/-/g, "+").replace(/_/g, "/")), new DecompressionStream("deflate-raw")));

byId("check").onclick = check;
stop.onclick = () => { ended(); fresh(); say("Stopped."); };
byId("link").onclick = async () => {
  const hash = await packed(text.value);
  if (hash.length > 60_000) return say("The text is too long for a link.", true);
  location.hash = hash;
  try { await navigator.clipboard.writeText(location.href); say("The link is copied."); } catch { say("The link is in the address of this page."); }
};
let typed;
text.oninput = () => { clearTimeout(typed); typed = setTimeout(check, QUIET); };
// What is much too long does not get into the field, which would take a browser long to show.
text.addEventListener("beforeinput", e => {
  const pasted = e.data ?? e.dataTransfer?.getData("text/plain") ?? "";
  if (pasted.length > LARGEST) { e.preventDefault(); tooLong(pasted.length); }
});
text.onkeydown = e => { if (e.key === "Enter" && (e.ctrlKey || e.metaKey)) { e.preventDefault(); check(); } };
for (const [name, example] of EXAMPLES) {
  const button = document.createElement("button");
  button.textContent = name;
  button.onclick = () => { text.value = example; check(); };
  byId("examples").append(button);
}

(async () => {
  try {
    program = await through(bytesOf(byId("program").textContent), new DecompressionStream("gzip"));
  } catch (e) {
    return say(`This browser cannot unpack the program: ${e.message}`, true);
  }
  fresh();
  const hash = location.hash.slice(1);
  try { text.value = hash ? await unpacked(hash) : EXAMPLES[0]?.[1] ?? ""; } catch { say("The address of this page has no text that can be read.", true); return; }
  check();
})();
addEventListener("hashchange", async () => { try { const what = await unpacked(location.hash.slice(1)); if (what !== text.value) { text.value = what; check(); } } catch { /* Not a text. */ } });
