// Compiles the Python sources with the very Python that will run them: node compile_modules.mjs SOURCES.zip TARGET
import { readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { loadPyodide } from "pyodide";

const [sources, target] = process.argv.slice(2);
const python = await loadPyodide();
python.FS.writeFile("/sources.zip", new Uint8Array(readFileSync(sources)));
python.runPython(readFileSync(fileURLToPath(new URL("compile_modules.py", import.meta.url)), "utf8"));
const modules = python.globals.get("packed")("/sources.zip").toJs();
writeFileSync(target, gzipSync(modules, { level: 9 }));
