/** Runs the library: Pyodide, and the modules that the build compiled for it. */

import importer from "./importer.py";

interface Python {
  runPython(code: string): unknown;
  globals: { get(name: string): (...args: unknown[]) => unknown };
}

type Load = (options: object) => Promise<Python>;
type Request = { id: number; request: string };

const here = new URL(".", self.location.href);
const tell = (said: object): void => self.postMessage(said);

async function modules(): Promise<Uint8Array> {
  const response = await fetch(new URL("python/modules.bin", here));
  if (!response.ok || !response.body) throw new Error(`python/modules.bin: ${response.status}`);
  const inflated = response.body.pipeThrough(new DecompressionStream("gzip"));
  return new Uint8Array(await new Response(inflated).arrayBuffer());
}

async function start(): Promise<(request: string, tell: (answer: string) => void) => void> {
  const packed = modules();
  packed.catch(() => {}); // told where it is waited for
  const { loadPyodide } = (await import(new URL("python/pyodide.mjs", here).href)) as { loadPyodide: Load };
  const python = await loadPyodide({
    indexURL: new URL("python/", here).href,
    lockFileContents: LOCK,
    env: { HOME: "/home", SYMPY_CACHE_SIZE: "10000" },
    checkAPIVersion: false,
  });
  tell({ state: "python" });
  python.runPython(importer);
  python.globals.get("install")(await packed);
  return python.globals.get("start")() as unknown as (request: string, tell: (answer: string) => void) => void;
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
