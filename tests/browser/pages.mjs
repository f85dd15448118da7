// The pages of a printed report. Usage: node pages.mjs FILE.pdf MOST
import fs from "node:fs";

const [file, most] = process.argv.slice(2);
const pages = (fs.readFileSync(file, "latin1").match(/\/Type\s*\/Page\b/g) ?? []).length;
console.log(`${file}: ${pages} pages`);
if (pages < 1 || pages > Number(most)) {
  console.error(`${file}: ${pages} pages, at most ${most} are wanted`);
  process.exit(1);
}
