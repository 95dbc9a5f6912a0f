// Serves a built site on this machine, as any host of files would.
import { createReadStream, existsSync, statSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";

const TYPES = {
  ".html": "text/html; charset=utf-8", ".js": "text/javascript", ".mjs": "text/javascript", ".css": "text/css",
  ".json": "application/json", ".svg": "image/svg+xml", ".png": "image/png", ".wasm": "application/wasm",
  ".woff2": "font/woff2", ".zip": "application/zip", ".xml": "application/xml",
};

export async function serve(folder, port = 0) {
  const asked = [];
  const server = createServer((request, response) => {
    const path = decodeURIComponent(new URL(request.url, "http://localhost").pathname);
    asked.push(path);
    let file = join(folder, normalize(path));
    if (existsSync(file) && statSync(file).isDirectory()) file = join(file, "index.html");
    if (!file.startsWith(folder) || !existsSync(file)) {
      response.writeHead(404).end();
      return;
    }
    const { size, mtimeMs } = statSync(file);
    const tag = `"${size}-${mtimeMs}"`;
    const head = { "content-type": TYPES[extname(file)] ?? "application/octet-stream", etag: tag, "cache-control": "max-age=600" };
    if (request.headers["if-none-match"] === tag) response.writeHead(304, head).end();
    else createReadStream(file).pipe(response.writeHead(200, { ...head, "content-length": size }));
  });
  await new Promise((listening) => server.listen(port, "127.0.0.1", listening));
  const { port: taken } = server.address();
  return {
    address: `http://127.0.0.1:${taken}`,
    asked,
    close: () => new Promise((closed) => (server.closeAllConnections(), server.close(closed))),
  };
}

if (process.argv[1] === new URL(import.meta.url).pathname) {
  const { address } = await serve(normalize(join(process.cwd(), process.argv[2] ?? "../build/site")), Number(process.argv[3] ?? 8000));
  console.log(address);
}
