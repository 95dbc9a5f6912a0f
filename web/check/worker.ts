/** Runs the library: Pyodide, and the modules that the build compiled for it. */

import importer from "./importer.py";
import { Memory, bytes, withRoomFor } from "./memory";

type Answer = (request: string, tell: (answer: string) => void) => void;

interface Python {
  runPython(code: string): unknown;
  globals: { get(name: string): (...args: unknown[]) => unknown };
  makeMemorySnapshot(): Uint8Array;
}

type Load = (options: object) => Promise<Python>;
type Request = { id: number; request: string };

const here = new URL(".", self.location.href);
const memory = new Memory(MEMORY);
const tell = (said: object): void => self.postMessage(said);

async function modules(): Promise<Uint8Array> {
  const response = await fetch(new URL("python/modules.bin", here));
  if (!response.ok || !response.body) throw new Error(`python/modules.bin: ${response.status}`);
  return bytes(response.body.pipeThrough(new DecompressionStream("gzip")));
}

async function pyodide(options: object): Promise<Python> {
  const { loadPyodide } = (await import(new URL("python/pyodide.mjs", here).href)) as { loadPyodide: Load };
  return loadPyodide({
    indexURL: new URL("python/", here).href,
    lockFileContents: LOCK,
    env: { HOME: "/home", SYMPY_CACHE_SIZE: "10000" },
    checkAPIVersion: false,
    ...options,
  });
}

const answering = (python: Python): Answer => python.globals.get("begin")() as unknown as Answer;

async function start(): Promise<Answer> {
  const kept = await memory.recall();
  if (kept) {
    try {
      return answering(await withRoomFor(kept, () => pyodide({ _loadSnapshot: kept })));
    } catch {
      await memory.forget();
    }
  }
  return startAnew();
}

async function startAnew(): Promise<Answer> {
  const packed = modules();
  packed.catch(() => {}); // told where it is waited for
  const python = await pyodide({ _makeSnapshot: true });
  tell({ state: "python" });
  python.runPython(importer);
  python.globals.get("install")(await packed);
  python.globals.get("prepare")();
  const prepared = python.makeMemorySnapshot(); // before anybody's formula is in it
  setTimeout(() => void memory.keep(prepared), 1000); // after what waits is answered: packing it takes a second
  return answering(python);
}

const waiting: Request[] = [];
self.addEventListener("message", ({ data }: MessageEvent<Request>) => waiting.push(data));

start().then(
  (answer) => {
    tell({ state: "ready" });
    const serve = ({ id, request }: Request): void => {
      tell({ id, begun: true });
      try {
        answer(request, (said) => tell({ id, answer: said }));
        tell({ id, done: true });
      } catch (error) {
        tell({ id, failed: error instanceof Error ? (error.message.split("\n").at(-2) ?? error.name) : "an unknown fault" });
      }
    };
    for (const one of waiting.splice(0)) serve(one);
    self.addEventListener("message", ({ data }: MessageEvent<Request>) => {
      waiting.length = 0;
      serve(data);
    });
  },
  (error: unknown) => tell({ failed: error instanceof Error ? error.message : String(error) }),
);
