// Puts the checker's page together: node checker.mjs TARGET, beside which the Python parts lie already.
import { createHash } from "node:crypto";
import { cpSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join, relative } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const target = process.argv[2];
const source = fileURLToPath(new URL("../check/", import.meta.url));
const modules = fileURLToPath(new URL("../node_modules/", import.meta.url));
const pyodide = join(modules, "pyodide");
const RUNTIME = ["pyodide.mjs", "pyodide.asm.mjs", "pyodide.asm.wasm", "python_stdlib.zip"];

for (const old of ["chunks", "fonts"]) rmSync(join(target, old), { recursive: true, force: true });
mkdirSync(join(target, "python"), { recursive: true });
for (const name of RUNTIME) cpSync(join(pyodide, name), join(target, "python", name));
cpSync(join(modules, "mathlive", "LICENSE.txt"), join(target, "LICENSE.mathlive.txt"));
for (const name of ["index.html", "icon.svg"]) cpSync(join(source, name), join(target, name));
cpSync(join(modules, "mathlive", "fonts"), join(target, "fonts"), { recursive: true });
const mathematics = join(modules, "@fontsource", "noto-sans-math");
cpSync(join(mathematics, "files", "noto-sans-math-latin-400-normal.woff2"), join(target, "fonts", "noto-sans-math-latin-400-normal.woff2"));
cpSync(join(mathematics, "LICENSE"), join(target, "LICENSE.noto.txt"));

const { info } = JSON.parse(readFileSync(join(pyodide, "pyodide-lock.json"), "utf8"));
const bundle = (entries, define, extra = {}) =>
  build({
    entryPoints: entries.map((name) => join(source, name)),
    outdir: target,
    bundle: true,
    minify: true,
    format: "esm",
    target: "es2022",
    loader: { ".py": "text" },
    external: ["fonts/*"],
    legalComments: "none",
    logLevel: "warning",
    define,
    ...extra,
  });

await bundle(["page.ts", "check.css"], {}, { splitting: true, chunkNames: "chunks/[name]-[hash]" });
const runtime = everything(join(target, "python")).map((name) => join(target, "python", name));
await bundle(["worker.ts"], {
  LOCK: JSON.stringify(JSON.stringify({ info, packages: {} })),
  MEMORY: JSON.stringify(named([join(source, "worker.ts"), join(source, "importer.py"), ...runtime])),
});

const files = everything(target).filter((name) => name !== "service_worker.js" && !/LICENSE/.test(name));
await bundle(["service_worker.ts"], { FILES: JSON.stringify(files), VERSION: JSON.stringify(named(files.map((name) => join(target, name)))) }, { format: "iife" });

/** A short name for what these files hold. */
function named(paths) {
  const hash = createHash("sha256");
  for (const path of paths) hash.update(relative(target, path).replaceAll("\\", "/")).update(readFileSync(path));
  return hash.digest("hex").slice(0, 16);
}

function everything(folder) {
  return readdirSync(folder, { withFileTypes: true, recursive: true })
    .filter((entry) => entry.isFile())
    .map((entry) => relative(folder, join(entry.parentPath ?? entry.path, entry.name)).replaceAll("\\", "/"))
    .sort();
}
