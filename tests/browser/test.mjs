// The page of every report in a real browser. Usage: node test.mjs FOLDER (with one folder for each report).
import fs from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";
import { inflateSync } from "node:zlib";
import { accessible, check, done, settled, visit } from "./visit.mjs";

const reports = path.resolve(process.argv[2] ?? "../../reports");
const LARGEST = 1_000_000;

/** The data of a page, unpacked by other means than the page's own. */
function dataOf(html) {
  const digits = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz!#$%()*+,-./:;=?@[]^_{|";
  const text = /<script type="text\/plain" id="\/data">([^<]*)<\/script>/.exec(html)[1], bytes = [];
  for (const chunk of text.match(/.{1,5}/g)) {
    const word = [...chunk.padEnd(5, "|")].reduce((sum, c) => sum * 85n + BigInt(digits.indexOf(c)), 0n);
    const four = Buffer.alloc(4);
    four.writeUInt32BE(Number(word));
    bytes.push(four.subarray(0, chunk.length - 1));
  }
  return JSON.parse(inflateSync(Buffer.concat(bytes)).toString());
}

const visibleText = page => page.evaluate(() => document.body.innerText);

/** Every formula is laid out by the browser as MathML: an index is lower and smaller than its base, a fraction is stacked. */
async function formulasAreLaidOut(page) {
  const found = await page.evaluate(() => {
    const box = e => e.getBoundingClientRect(), wrong = [];
    let formulas = 0, scripts = 0, fractions = 0;
    for (const math of document.querySelectorAll("math")) {
      if (!math.checkVisibility()) continue;
      formulas++;
      const b = box(math);
      if (!(b.width > 0 && b.height > 0)) wrong.push("no size: " + math.textContent);
      for (const s of math.querySelectorAll("msub")) {
        scripts++;
        const [base, low] = s.children;
        if (!(box(low).bottom > box(base).bottom - 1 && box(low).left >= box(base).right - 2)) wrong.push("index: " + s.textContent);
      }
      for (const f of math.querySelectorAll("mfrac")) {
        fractions++;
        const [top, bottom] = f.children;
        if (!(box(top).bottom <= box(bottom).top + 1)) wrong.push("fraction: " + f.textContent);
      }
      for (const a of math.querySelectorAll("annotation"))
        if (getComputedStyle(a).display !== "none") wrong.push("LaTeX is shown: " + a.textContent);
    }
    return { formulas, scripts, fractions, wrong: wrong.slice(0, 5) };
  });
  check(found.formulas > 0, "there are formulas");
  check(found.wrong.length === 0, `formulas are laid out: ${found.wrong.join("; ")}`);
  return found;
}

/** A page without most of what repeats itself: one row is like the next, and to look at all of them takes minutes. */
async function thinned(page, where) {
  await page.evaluate(() => {
    const many = ".matrix tbody tr:nth-child(n+4), .verdicts tbody tr:nth-child(n+4), .claims > :nth-child(n+12), .trajectory:nth-of-type(n+4)";
    for (const e of document.querySelectorAll(many)) if (!e.matches(".here, .pair") && !e.querySelector(".here, .pair")) e.remove();
  });
  await accessible(page, where);
}

for (const id of fs.readdirSync(reports).sort()) {
  const file = path.join(reports, id, "index.html");
  if (!fs.existsSync(file)) continue;
  const url = pathToFileURL(file).href;
  const json = JSON.parse(fs.readFileSync(path.join(reports, id, "report.json"), "utf8"));
  const size = fs.statSync(file).size;
  check(size < LARGEST, `${id}: the page has ${size} bytes`);

  // Without the script everything essential is there.
  await visit({ javaScriptEnabled: false, viewport: { width: 1280, height: 900 } }, url, async page => {
    const text = await page.locator("body").innerText();
    const matrix = json.trajectories.length ? ["Claims and motions"] : [];
    for (const part of ["What was found", ...matrix, json.derivation.sha256])
      check(text.includes(part), `${id}: without a script, "${part}" is shown`);
    // A large matrix comes as runs of equal cells: letters, and how many of them; a point is no pair.
    const runs = (await page.locator(".matrix tbody td.runs").allTextContents()).flatMap(text => text.split(" "));
    const inRuns = runs.filter(run => run[0] !== ".").reduce((sum, run) => sum + Number(run.split("*")[1] ?? 1), 0);
    const cells = inRuns + await page.locator(".matrix tbody td[class]:not(.runs)").count();
    const pairs = json.claims.flatMap(c => c.results).length;
    check(cells === pairs, `${id}: ${cells} cells for ${pairs} pairs`);
    check(await page.locator(".filters").isHidden(), `${id}: filters that cannot work are not shown`);
  });

  // With it: every link leads somewhere, formulas are laid out, filters work, the address keeps the state.
  let formulas, opened = "", special = 0;
  await visit({ viewport: { width: 1280, height: 900 } }, url, async page => {
    const dead = await page.evaluate(() => [...document.querySelectorAll('a[href^="#"]')]
      .map(a => decodeURIComponent(a.getAttribute("href").slice(1))).filter(h => !document.getElementById(h)));
    check(dead.length === 0, `${id}: links without a place: ${[...new Set(dead)].slice(0, 5)}`);
    const twice = await page.evaluate(() => { const s = new Set(); return [...document.querySelectorAll("[id]")].map(e => e.id).filter(i => s.has(i) || !s.add(i)); });
    check(twice.length === 0, `${id}: places with one name: ${twice}`);
    // A cell leads to a pair of its own claim, also where claims without a row stand between.
    const astray = await page.evaluate(async () => {
      const out = [], rows = [...document.querySelectorAll(".matrix tbody tr")];
      for (const row of rows.slice(0, 12)) {
        row.querySelector("td[class]:not(.off)").click();
        const there = () => decodeURIComponent(location.hash).slice(1).split("@")[0] === row.cells[0].textContent;
        for (let waited = 0; waited < 2000 && !there(); waited += 20) await new Promise(r => setTimeout(r, 20));
        if (!there()) out.push(`${row.cells[0].textContent} to ${location.hash}`);
      }
      return out;
    });
    check(astray.length === 0, `${id}: cells that lead to another claim: ${astray.slice(0, 3)}`);
    const elements = await page.evaluate(() => document.querySelectorAll("*").length);
    check(elements < 31000, `${id}: ${elements} elements`);
    // Formulas, with everything unfolded that is not a table of verdicts.
    await page.evaluate(() => document.querySelectorAll("details").forEach(d => { d.open = true; }));
    formulas = await formulasAreLaidOut(page);
    // A correction shows the source, in which it has to be made; a member of a family, and a motion that was drawn, what is pasted.
    await page.evaluate(() => document.querySelectorAll("code.difference, .region pre, pre.toml").forEach(e => { e.hidden = true; }));
    const raw = (await visibleText(page)).match(/.{0,30}\\[a-zA-Z]{2,}.{0,30}/);
    check(!raw, `${id}: LaTeX is shown: ${raw}`);
    await page.evaluate(() => document.querySelectorAll("details").forEach(d => { d.open = false; }));

    // Every claim is told once, and links to it lead somewhere (see above).
    const ids = new Set(json.claims.map(c => c.id)).size;
    const told = await settled(() => page.locator("#\\/claims > article.claim, #\\/claims > .family").count(), n => n === ids);
    check(told === ids, `${id}: the section tells of ${told} claims`);
    // What is about fields and ranges alone has no pairs.
    if (json.trajectories.length === 0) {
      for (const empty of ["matrix", "trajectories"]) {
        check(!await page.locator(`#\\/${empty}`).isVisible(), `${id}: no empty section on ${empty}`);
        check(await page.locator(`nav a[href="#/${empty}"]`).count() === 0, `${id}: no link to an empty section on ${empty}`);
      }
      return;
    }

    // A cell leads to its pair, by click and by Enter, and back.
    const cell = page.locator(".matrix td.h").first();
    await cell.click();
    check(/^#.+@.+/.test(decodeURIComponent(new URL(page.url()).hash)), `${id}: a click changes the address`);
    await page.locator("tr.here").first().waitFor();
    check(await page.locator("tr.here").first().isVisible(), `${id}: the pair is shown`);
    const wanted = json.claims.flatMap(c => c.results.map(r => ({ ...r, name: c.reading ? `${c.id}/${c.reading}` : c.id })));
    const failing = wanted.find(r => r.verdict === "fails" && r.witness && r.residual && r.samples > 2);
    if (failing) {
      const address = `#${failing.name}@${failing.trajectory}`;
      await page.goto(url + address);
      // The pair that was open before must not be taken for this one.
      await page.reload();
      const detail = page.locator("tr.here + tr.pair");
      await detail.locator("svg").nth(1).waitFor();
      check(await detail.isVisible(), `${id}: an address opens its pair: ${address}`);
      check(await detail.locator("svg").count() === 2, `${id}: a pair has two drawings`);
      check(await detail.locator("svg title").count() === 2, `${id}: drawings have titles`);
      const lines = await detail.locator("path.curve:not(.pass)").evaluateAll(l => l.map(p => p.getAttribute("d")));
      check(lines.every(l => l.length > 0 && !/NaN|Infinity/.test(l)), `${id}: curves have finite points`);
      const enough = Math.min(30, failing.samples);
      check((lines[0].match(/C/g) ?? []).length + 1 >= enough, `${id}: a curve has ${lines[0].length} characters, too few of ${failing.samples} samples`);
      // A drawing can be asked: a value under the keys, a stretch, a line less.
      const drawing = detail.locator("svg").nth(1), curves = drawing.locator("path.curve");
      const whole = await curves.first().getAttribute("d");
      await drawing.focus();
      for (const key of ["ArrowRight", "ArrowRight"]) await page.keyboard.press(key);
      check(/^t = .+: left side .+, right side /.test(await detail.locator("output").nth(1).innerText()), `${id}: a drawing tells its values`);
      await page.keyboard.press("+");
      check(await curves.first().getAttribute("d") !== whole, `${id}: a stretch can be looked at`);
      await page.keyboard.press("Escape");
      check(await curves.first().getAttribute("d") === whole, `${id}: and all again`);
      await detail.locator(".keys button").nth(2).click();
      check(await curves.count() === 1, `${id}: a line can be put away`);
      await detail.locator("details summary").click();
      await detail.locator("details tbody tr").first().waitFor();
      check(await detail.locator("details tbody tr").count() === (lines[0].match(/C/g) ?? []).length + 1, `${id}: the points of a curve are there as numbers`);
      const pasted = await detail.locator("pre").innerText();
      // On a page of thousands of pairs in six digits at least.
      const told = Number(/^left = (.+)$/m.exec(pasted)?.[1]), left = failing.witness.left;
      check(wanted.length > 1000 ? Math.abs(told - left) <= 1e-5 * Math.abs(left) : told === left, `${id}: the witness is there: ${told}`);
      opened = address;
    }
    // What is looked for, and what is tried at events, is drawn as what it is.
    const data = dataOf(fs.readFileSync(file, "utf8"));
    const motions = json.trajectories.map(t => t.id);
    const numbered = data.pairs.flatMap(([name, columns]) => columns.map(column => [name, column]));
    const curves = numbered.map(([name, column], k) => [name, [String(column), [data.curves.map(c => c[k])]]]).filter(([, [, [c]]]) => c[0] !== null);
    const drawn = (name, some) => curves.find(([of, [, [c]]]) => of === name && some(c))?.[1];
    const kinds = { sought: ["Looked for: ", c => c[10] === 0, data.pairs.map(([name]) => name)], events: ["each time", () => true, Object.keys(data.events)] };
    for (const [kind, [words, some, names]] of Object.entries(kinds)) {
      const name = names.find(n => drawn(n, some));
      if (!name) continue;
      await page.goto(`${url}#${name}@${motions[drawn(name, some)[0]]}`);
      const detail = page.locator("tr.here + tr.pair");
      await detail.locator("svg").nth(1).waitFor();
      check((await detail.innerText()).includes(words), `${id}: ${name} says what is drawn (${kind})`);
      check(await detail.locator("svg").count() === 2, `${id}: ${name} has two drawings (${kind})`);
      if (kind === "events") check(await detail.locator("line.when").count() >= 2, `${id}: the events of ${name} are marked`);
      special++;
    }
    // Keys in the matrix.
    await page.goto(url + "#/matrix");
    await page.locator('.matrix td[tabindex="0"]').focus();
    await page.keyboard.press("ArrowDown");
    await page.keyboard.press("Enter");
    const at = await settled(() => decodeURIComponent(page.url()), address => address.includes("@"));
    check(at.includes("@"), `${id}: arrows and Enter lead to a pair`);

    // Filters.
    for (const verdict of ["h", "f", "n", "u"]) {
      const word = { h: "holds", f: "fails", n: "not-applicable", u: "undecided" }[verdict];
      await page.goto(`${url}#/matrix?verdict=${verdict}`);
      const right = wanted.filter(r => r.verdict === word).length;
      const shown = await settled(() => page.locator(".matrix tbody td[class]").evaluateAll(l => l.filter(a => a.checkVisibility({ visibilityProperty: true })).length), n => n === right);
      check(shown === right, `${id}: the filter ${word} shows ${shown}`);
    }
    const { name, trajectory } = wanted[0];
    await page.goto(`${url}#/matrix`);
    await page.fill("[name=claim]", name);
    await page.fill("[name=trajectory]", trajectory);
    const kept = state => state.includes(`claim=${name}`) && state.includes(`trajectory=${trajectory}`);
    const state = await settled(async () => decodeURIComponent(await page.evaluate(() => location.hash)), kept);
    check(kept(state), `${id}: the address keeps the filters: ${state}`);
    await page.reload();
    check(await page.inputValue("[name=claim]") === name, `${id}: filters are read from the address`);
    const few = n => n >= 1 && n < 1 + wanted.filter(r => r.name.includes(name)).length;
    check(few(await settled(() => page.locator(".matrix tbody tr:not([hidden])").count(), few)), `${id}: rows are left by the filters`);
    await page.click(".filters button");
    const hidden = await settled(() => page.locator(".matrix tbody tr[hidden]").count(), n => n === 0);
    check(hidden === 0, `${id}: everything is shown again`);
  });

  await visit({ viewport: { width: 1280, height: 900 } }, url, page => thinned(page, `${id}, as it opens`));
  await visit({ viewport: { width: 1280, height: 900 } }, url + opened, page => thinned(page, `${id}, with a pair`));

  // Narrow and dark: nothing is wider than the screen.
  await visit({ viewport: { width: 360, height: 740 }, colorScheme: "dark" }, url, async page => {
    const width = await page.evaluate(() => document.documentElement.scrollWidth);
    check(width <= 360, `${id}: on a phone the page is ${width} wide`);
    if (opened) {
      await page.goto(url + opened);
      await page.locator("tr.here + tr.pair svg").nth(1).waitFor();
      const drawing = await page.locator("tr.here + tr.pair svg").first().boundingBox();
      check(drawing.width <= 360, `${id}: on a phone a drawing is ${drawing.width} wide`);
    }
    await thinned(page, `${id}, narrow and dark`);
  });
  console.log(`${id}: ${size} bytes, ${formulas.formulas} formulas, ${formulas.scripts} indices, ${formulas.fractions} fractions, ${special} special curves`);
}
await done();
