// Puts the page together: one HTML file with the program in it. Usage: node pack.mjs PROGRAM.wasm OUTPUT.html
import fs from "node:fs";
import path from "node:path";
import { gzipSync } from "node:zlib";

const [program, output] = process.argv.slice(2);
const here = new URL(".", import.meta.url).pathname;
const read = name => fs.readFileSync(path.join(here, name), "utf8");
const examples = fs.readdirSync(path.join(here, "examples")).sort().map(name => [name.replace(/^\d+-|\.[a-z]+$/g, "").replace(/-/g, " "), read(`examples/${name}`)]);
// Nothing in a text ends the script that it stands in.
const literal = JSON.stringify(examples).replace(/</g, "\\u003c");
const version = /^version = "(.*)"/m.exec(read("../Cargo.toml"))[1];
const script = read("page.js").replace("/*EXAMPLES*/[]", () => literal);
const put = {
  VERSION: version,
  SECONDS: /SECONDS = (\d+)/.exec(script)[1],
  PROGRAM: gzipSync(fs.readFileSync(program), { level: 9 }).toString("base64"),
  WORKER: read("worker.js"),
  SCRIPT: script,
};
const page = read("page.html").replace(/\b(VERSION|SECONDS|PROGRAM|WORKER|SCRIPT)\b/g, (_, name) => put[name]);
fs.mkdirSync(path.dirname(path.resolve(output)), { recursive: true });
fs.writeFileSync(output, page);
console.log(`${output}: ${page.length} bytes, ${gzipSync(page).length} compressed`);
