// The documentation as a site: every example with a fold is checked where it stands, every derivation of the gallery in its page.
// Usage: node site.mjs SITE
import fs from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";
import { check, done, visit } from "./visit.mjs";

const site = path.resolve(process.argv[2]), within = pathToFileURL(site).href;
const docs = path.join(site, "docs");
/** What was found in the page in which texts are checked, once it is done. */
async function found(frame, seconds = 60) {
  const end = Date.now() + 1000 * seconds;
  for (;;) {
    const state = await frame.locator("#state").innerText().catch(() => "");
    // What was found is in the page a moment after it is told that it is.
    const words = await frame.frameLocator("#found").locator("body").innerText().catch(() => "");
    if (/^Done/.test(state) && words.trim()) return words;
    if (!/^Done/.test(state) && !/^(|Loading …|Working …)$/.test(state)) return `not done: ${state}`;
    if (Date.now() > end) return `not done within ${seconds} seconds: ${state}`;
    await new Promise(r => setTimeout(r, 50));
  }
}

let folds = 0, runs = 0;
for (const name of fs.readdirSync(docs).filter(n => n.endsWith(".html") && n !== "print.html")) {
  const text = fs.readFileSync(path.join(docs, name), "utf8");
  if (!text.includes('<details class="try"')) continue;
  await visit({ within, viewport: { width: 1280, height: 900 } }, pathToFileURL(path.join(docs, name)).href, async page => {
    const all = page.locator("details.try");
    for (let k = 0; k < await all.count(); k++) {
      const frame = all.nth(k).frameLocator("iframe");
      check(!await all.nth(k).locator("iframe").getAttribute("src"), `${name}, fold ${k}: nothing is loaded before it is opened`);
      await all.nth(k).locator("summary").click();
      const words = await found(frame);
      check(/follows|wrong|hold/i.test(words) && !/^not done/.test(words), `${name}, fold ${k}: ${words.slice(0, 200)}`);
      folds++;
      await all.nth(k).locator("summary").click();
    }
  });
}
const gallery = fs.readFileSync(path.join(docs, "gallery.html"), "utf8");
for (const [, hash] of gallery.matchAll(/href="\.\.\/try\.html(#[^"]*)">▶/g)) {
  await visit({ viewport: { width: 390, height: 844 } }, pathToFileURL(path.join(site, "try.html")).href + hash, async page => {
    const words = await found(page);
    check(!/^not done/.test(words), `a derivation of the gallery, ${await page.locator("#text").inputValue().then(t => t.slice(0, 80))}: ${words}`);
    console.log(`${(await page.locator("#state").innerText())} ${words.split("\n").find(l => l.trim())}`);
    runs++;
  });
}
check(folds >= 10 && runs >= 10, `${folds} folds, ${runs} derivations`);
await done();
