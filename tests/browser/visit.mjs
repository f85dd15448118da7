// Pages in a real browser, one after the other: what is looked at is counted, and the console and the network stay silent.
import assert from "node:assert/strict";
import fs from "node:fs";
import { createRequire } from "node:module";
import { chromium } from "playwright-core";

const axe = fs.readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const executablePath = process.env.CHROMIUM ?? "/usr/bin/chromium";
const args = ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
  "--disable-component-update", "--disable-sync"];

let checks = 0;
export const check = (good, what) => { checks++; assert.ok(good, what); };
const browser = await chromium.launch({ executablePath, args, headless: true });

/** Opens a page as someone new, who remembers nothing; every console error is kept, and every request for what does not begin with
    `within`: the file itself, unless given. */
export async function visit({ within, ...options }, url, work) {
  const own = within ?? url.split("#")[0];
  const context = await browser.newContext({ offline: true, ...options });
  const page = await context.newPage();
  const seen = { errors: [], requests: [] };
  page.on("console", m => { if (m.type() === "error" || m.type() === "warning") seen.errors.push(m.text()); });
  page.on("pageerror", e => seen.errors.push(String(e)));
  page.on("request", r => { if (!r.url().startsWith(own) && !r.url().startsWith("blob:")) seen.requests.push(r.url()); });
  try {
    await page.goto(url);
    await work(page);
  } finally {
    await context.close();
  }
  check(seen.errors.length === 0, `the console stays silent: ${seen.errors.join("; ")}`);
  check(seen.requests.length === 0, `nothing is fetched: ${seen.requests.join(", ")}`);
}

/** What is read of a page once it is as wanted, or after five seconds: what a page does takes a while, the longer the busier the machine. */
export async function settled(read, wanted) {
  const last = Date.now() + 5000;
  for (;;) {
    const found = await read();
    if (wanted(found) || Date.now() > last) return found;
    await new Promise(r => setTimeout(r, 20));
  }
}

/** What is wrong with a page for those who do not see it, or see it badly: nothing. */
export async function accessible(page, where) {
  await page.evaluate(axe);
  const result = await page.evaluate(() => axe.run(document, { resultTypes: ["violations"] }));
  const bad = result.violations.map(v => `${v.id} (${v.nodes.length}): ${v.help}, ${v.nodes[0].html.slice(0, 160)}`);
  check(bad.length === 0, `${where}: ${bad.join("\n")}`);
}

/** Says how much was looked at, and leaves nothing behind. */
export async function done() {
  await browser.close();
  console.log(`${checks} checks passed`);
}
