// The program in a worker: one instance for each text, so that nothing is left of the one before. It asks a system of preview 1 of
// WASI for a few things: its text on standard input, its page on standard output, words on standard error. It has no file.
"use strict";
const BADF = 8, NOSYS = 52;
class Exit { constructor(code) { this.code = code; } }

function run(module, text) {
  const input = new TextEncoder().encode(text), out = [[], []];
  let at = 0, memory;
  const view = () => new DataView(memory.buffer), bytes = () => new Uint8Array(memory.buffer);
  /** The pieces of memory that a list names. */
  const pieces = (list, n) => Array.from({ length: n }, (_, i) => [view().getUint32(list + 8 * i, true), view().getUint32(list + 8 * i + 4, true)]);
  const none = (count, size) => { view().setUint32(count, 0, true); view().setUint32(size, 0, true); return 0; };
  const calls = {
    args_sizes_get: none, args_get: () => 0, environ_sizes_get: none, environ_get: () => 0,
    clock_time_get: (_id, _precision, to) => { view().setBigUint64(to, BigInt(Math.round(performance.now() * 1e6)), true); return 0; },
    // Tables are in the same order each time.
    random_get: (to, n) => { bytes().fill(7, to, to + n); return 0; },
    fd_read: (fd, list, n, read) => {
      if (fd !== 0) return BADF;
      let all = 0;
      for (const [to, room] of pieces(list, n)) {
        const part = input.subarray(at, at + room);
        bytes().set(part, to);
        at += part.length;
        all += part.length;
      }
      view().setUint32(read, all, true);
      return 0;
    },
    fd_write: (fd, list, n, written) => {
      if (fd !== 1 && fd !== 2) return BADF;
      let all = 0;
      for (const [from, size] of pieces(list, n)) {
        out[fd - 1].push(bytes().slice(from, from + size));
        all += size;
      }
      view().setUint32(written, all, true);
      return 0;
    },
    fd_fdstat_get: (fd, to) => { if (fd > 2) return BADF; bytes().fill(0, to, to + 24); view().setUint8(to, 2); return 0; },
    fd_close: () => 0, fd_prestat_get: () => BADF, fd_prestat_dir_name: () => BADF, sched_yield: () => 0,
    proc_exit: code => { throw new Exit(code); },
  };
  const wasi = Object.fromEntries(WebAssembly.Module.imports(module).map(({ name }) => [name, calls[name] ?? (() => NOSYS)]));
  const instance = new WebAssembly.Instance(module, { wasi_snapshot_preview1: wasi });
  memory = instance.exports.memory;
  let code = 0, fault;
  try { instance.exports._start(); } catch (e) { if (e instanceof Exit) code = e.code; else fault = e; }
  const [page, words] = out.map(parts => { const decoder = new TextDecoder(); return parts.map(p => decoder.decode(p, { stream: true })).join("") + decoder.decode(); });
  if (fault instanceof RangeError) return { problem: "The text is nested too deeply for this page." };
  if (code === 75) return { problem: `This text takes more work than a page does. The program on your machine leaves out what is too much, and says the rest: rederive FILE. (${words.trim()})` };
  if (fault || code) return { problem: `A defect of rederive: please report it, with the text. ${words.trim() || fault?.message || `code ${code}`}` };
  return { page };
}

let module;
onmessage = ({ data }) => {
  const start = performance.now();
  if (data.program) { module = new WebAssembly.Module(data.program); return; }
  let found;
  try { found = run(module, data.text); } catch (e) { found = { problem: `The program could not be started: ${e.message}` }; }
  postMessage({ asked: data.asked, milliseconds: performance.now() - start, ...found });
};
