// The page in which texts are checked, in a real browser, from disk: nothing is fetched, verdicts come, bad texts get a clear word.
// Usage: node web.mjs PAGE.html
import fs from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";
import { gzipSync } from "node:zlib";
import { accessible, check, done, settled, visit } from "./visit.mjs";

const file = path.resolve(process.argv[2]), url = pathToFileURL(file).href;
const size = gzipSync(fs.readFileSync(file), { level: 9 }).length;
check(size < 5_000_000, `the page has ${size} bytes compressed`);

const state = page => page.locator("#state").innerText();
/** What stands in the page of what was found, once the program is done. */
async function found(page, wanted, seconds = 60) {
  const end = Date.now() + 1000 * seconds;
  for (;;) {
    const words = await page.frameLocator("#found").locator("body").innerText().catch(() => "");
    if (/^Done/.test(await state(page)) && wanted.test(words)) return words;
    if (Date.now() > end) check(false, `${wanted} is expected; ${await state(page)}; ${words.slice(0, 400)}`);
    await new Promise(r => setTimeout(r, 50));
  }
}
const put = (page, text) => page.locator("#text").fill(text);

for (const viewport of [{ width: 1280, height: 900 }, { width: 390, height: 844 }]) {
  await visit({ viewport }, url, async page => {
    const start = Date.now();
    await found(page, /follows/);
    console.log(`first verdict after ${((Date.now() - start) / 1000).toFixed(1)} s at ${viewport.width} pixels`);
    await accessible(page, `${viewport.width}`);
    const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    check(wide <= 0, `nothing is wider than the window: ${wide}`);
  });
}

await visit({ viewport: { width: 1280, height: 900 } }, url, async page => {
  await found(page, /follows/);
  for (const name of await page.locator("#examples button").allInnerTexts()) {
    await page.getByRole("button", { name, exact: true }).click();
    await found(page, /follows|wrong|hold/i);
  }
  // Typed, and what is wrong with the right one beside it.
  await put(page, "(a+b)^2 = a^2 + b^2 + 3ab");
  await found(page, /wrong/);
  // Chains, papers, derivation files that cannot be read.
  await put(page, "x^2-y^2 &= (x-y)(x+y) \\\\ &= x(x+y) - y(x+y)");
  await found(page, /follows/);
  await put(page, "[derivation]\ntitle = 'Nothing'");
  await found(page, /missing|concerns/);
  // What strangers paste is text.
  await put(page, "$a=<script>parent.postMessage(1)</script><img src=x onerror=alert(1)>$");
  await found(page, /./);
  // No text; a text without formulas.
  await put(page, "");
  check(/Nothing is written/.test(await settled(() => state(page), s => /Nothing/.test(s))), "an empty text gets a word");
  await put(page, "No formula stands here $");
  await found(page, /./);
  // What is said next is of the next text.
  const nothing = async () => { await put(page, ""); await settled(() => state(page), s => /Nothing/.test(s)); };
  // Macros without an end, braces without number, another file: the page lives on.
  for (const bad of ["\\def\\a{\\a\\a}\\[\\a=1\\]", "\\[" + "{".repeat(30_000) + "=1\\]", "\\input{/etc/passwd} $x=x$", "\\[x=" + "\\sqrt{".repeat(20_000)]) {
    await nothing();
    await put(page, bad);
    const said = await settled(() => state(page), s => /^(Done|Not done|A defect|The )/.test(s) && !/Working/.test(s));
    check(!/defect/.test(said), `${bad.slice(0, 20)}: ${said}`);
  }
  // A formula of 2²³ terms: it takes more work than it may, which cannot end there alone.
  const calls = [..."bcdefghijklmnopqrstuvwx"].map((name, i) => `'f_{\\rm ${name}}(\\alpha)' = { role = 'abbreviation', arguments = ['\\alpha'], formula = 'f_{\\rm ${"abcdefghijklmnopqrstuvw"[i]}}(\\alpha+1)+f_{\\rm ${"abcdefghijklmnopqrstuvw"[i]}}(2\\alpha)' }`);
  await nothing();
  await put(page, ["[derivation]", "title = 'x'", "concerns = 'y'", "[symbols]", "'t' = { role = 'time' }", "'x' = { role = 'state' }",
    "'f_{\\rm a}(\\alpha)' = { role = 'abbreviation', arguments = ['\\alpha'], formula = '\\sin\\alpha' }", ...calls,
    "[system.s]", "states = ['x']", "equations = ['\\dot x=-x']", "[[trajectory]]", "id = 'a'", "system = 's'", "initial = { 'x' = 1 }", "span = [0, 1]",
    "[[claim]]", "id = 'c'", "says = 's'", "always = ['x=f_{\\rm x}(x)']"].join("\n"));
  const told = await settled(() => state(page), s => /^(Done|Not done|A defect|The |This text)/.test(s) && !/Working/.test(s));
  check(/^This text takes more work than a page does/.test(told) && /work limit: reading a formula/.test(told), told);
  await put(page, "1+1=2");
  await found(page, /follows/);
  // A text that takes long is given up at once when asked.
  await put(page, "x".repeat(2_000_001));
  check(/2000000 are taken/.test(await settled(() => state(page), s => /taken/.test(s))), "a text that is too long gets a word");
});

// Three texts as a new user has them, on a phone: a chain with a slip, a page of LaTeX, a derivation. What is found can be read there, by
// everybody, and what is wrong has the right one beside it.
const root = new URL("../..", import.meta.url).pathname;
const THREE = [
  ["(x+h)^3 - x^3 &= 3x^2h + 3xh^2 + h^3 \\\\\n &= h(3x^2 + 3xh - h^2)", /wrong[^]*Holds/],
  [fs.readFileSync(path.join(root, "tests/lint/page.tex"), "utf8"), /2 wrong/],
  [fs.readFileSync(path.join(root, "derivations/lorentz.toml"), "utf8"), /velocit/i],
];
await visit({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true }, url, async page => {
  await found(page, /follows/);
  for (const [text, wanted] of THREE) {
    const start = Date.now();
    await put(page, text);
    await page.locator("#check").tap();
    await found(page, wanted);
    console.log(`a new user's text of ${text.length} characters: ${((Date.now() - start) / 1000).toFixed(1)} s`);
    await accessible(page, `a text of ${text.length} characters`);
    const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    check(wide <= 0, `nothing is wider than the phone: ${wide}`);
    const inside = await page.frameLocator("#found").locator("html").evaluate(e => e.scrollWidth - e.clientWidth);
    check(inside <= 0, `nor in what was found: ${inside}`);
  }
});

// Ten megabytes; a text that takes longer than it is given; stopped in the middle: a word each time, and the page lives on.
await visit({ viewport: { width: 1280, height: 900 } }, url, async page => {
  await found(page, /follows/);
  await page.locator("#text").focus();
  await page.keyboard.insertText("\\[x=x\\]\n".repeat(1_250_000));
  check(/^The text has 10000000 characters; 2000000 are taken/.test(await settled(() => state(page), s => /taken/.test(s))), "ten megabytes get a word");
  check((await page.locator("#text").inputValue()).length < 1000, "and do not get into the field");
  const heavy = fs.readFileSync(path.join(root, "derivations/deriglazov-comment.toml"), "utf8");
  await put(page, heavy);
  await page.locator("#check").click();
  await page.locator("#stop").click();
  check(/Stopped/.test(await settled(() => state(page), s => /Stopped/.test(s))), "what works is stopped");
  await put(page, heavy);
  const end = Date.now() + 45_000;
  let said = "";
  while (Date.now() < end && !/^(Done|Not done)/.test(said)) { await new Promise(r => setTimeout(r, 200)); said = await state(page); }
  check(/^(Done|Not done within 30 seconds)/.test(said), `a derivation that takes long: ${said}`);
  console.log(`a derivation of ${heavy.length} characters: ${said}`);
  await put(page, "1+1=2");
  await found(page, /follows/);
});

// A link contains the text.
await visit({ viewport: { width: 1280, height: 900 } }, url, async page => {
  await found(page, /follows/);
  await put(page, "\\cos 2x = 1 - 3\\sin^2 x");
  await found(page, /wrong/);
  await page.locator("#link").click();
  const hash = await settled(() => page.evaluate(() => location.hash), h => h.length > 1);
  check(hash.length > 10, "the address has the text");
  await page.reload();
  await found(page, /wrong/);
  check((await page.locator("#text").inputValue()).startsWith("\\cos 2x"), "the text is back");
});
await done();
