// What the cells of an executed notebook show, in a real browser, light and dark. Usage: node notebook.mjs CELLS.json
// The file has the pieces of HTML that the cells gave, and pictures as data.
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { pathToFileURL } from "node:url";
import { accessible, check, done, visit } from "./visit.mjs";

const cells = JSON.parse(fs.readFileSync(process.argv[2], "utf8"));
check(cells.length >= 3, `there are ${cells.length} cells to look at`);
const folder = fs.mkdtempSync(path.join(os.tmpdir(), "rederive-notebook-"));
// As Jupyter has it: the theme is an attribute of the page, and need not be that of the system.
const themes = [["light", "light", "#ffffff", "#000000"], ["dark", "dark", "#111111", "#ffffff"], ["light", "dark", "#111111", "#ffffff"], ["dark", "light", "#ffffff", "#000000"]];
const colours = new Set();
for (const [system, theme, back, front] of themes) {
  const file = path.join(folder, `${system}-${theme}.html`);
  const body = cells.map((cell, i) => `<section aria-label="cell ${i + 1}">${cell}</section>`).join("\n");
  fs.writeFileSync(file, `<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><title>Cells</title></head>
<body data-jp-theme-light="${theme === "light"}" style="background:${back};color:${front}"><main><h1>Cells</h1>${body}</main></body></html>`);
  await visit({ viewport: { width: 900, height: 900 }, colorScheme: system }, pathToFileURL(file).href, async page => {
    const where = `${theme} on a ${system} system`;
    for (const section of await page.locator("section").all()) {
      const box = await section.boundingBox();
      check(box.height > 10 && box.width > 100, `${where}: a cell shows something`);
    }
    const drawings = await page.locator("section svg").evaluateAll(all => all.map(e => e.getBoundingClientRect()).filter(b => b.width < 50 || b.height < 30).length);
    check(drawings === 0, `${where}: ${drawings} drawings without a size`);
    const words = await page.locator(".rederive .holds, .rederive .proved").evaluateAll(all => all.map(e => getComputedStyle(e).color));
    check(words.length > 0, `${where}: verdicts have their colour`);
    words.forEach(c => colours.add(`${theme} ${c}`));
    check(await page.evaluate(() => document.documentElement.scrollWidth) <= 900, `${where}: nothing is wider than the screen`);
    await accessible(page, where);
  });
}
check(colours.size === 2, `the theme of the notebook gives the colours, not that of the system: ${[...colours]}`);
fs.rmSync(folder, { recursive: true, force: true });
await done();
