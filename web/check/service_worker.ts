/** Keeps the page's files, so that it works without a network, and holds the worker to the policy of the page. */

const worker = self as unknown as {
  addEventListener(type: string, listener: (event: never) => void): void;
  location: Location;
  clients: { claim(): Promise<void> };
  skipWaiting(): Promise<void>;
};
const CACHE = `radartrack-check-${VERSION}`;
const POLICY =
  "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; connect-src 'self'; worker-src 'self'; base-uri 'none'";
const root = new URL("./", worker.location.href);

worker.addEventListener("install", (event: ExtendableEvent) => {
  event.waitUntil(caches.open(CACHE).then((cache) => cache.addAll(FILES.map((file) => new URL(file, root).href))));
});

worker.addEventListener("activate", (event: ExtendableEvent) => {
  event.waitUntil(forget().then(() => worker.clients.claim()));
});

worker.addEventListener("fetch", (event: FetchEvent) => {
  const address = new URL(event.request.url);
  if (event.request.method !== "GET" || !address.href.startsWith(root.href)) return;
  const name = address.pathname.slice(root.pathname.length) || "index.html";
  if (FILES.includes(name)) event.respondWith(kept(name, event.request));
});

async function kept(name: string, request: Request): Promise<Response> {
  const cache = await caches.open(CACHE);
  const found = (await cache.match(new URL(name, root).href)) ?? (await fetch(request));
  if (!name.endsWith(".js") && !name.endsWith(".mjs")) return found;
  const headers = new Headers(found.headers);
  headers.set("Content-Security-Policy", POLICY);
  return new Response(found.body, { status: found.status, headers });
}

async function forget(): Promise<void> {
  const names = await caches.keys();
  const old = names.filter((name) => name.startsWith("radartrack-check-") && name !== CACHE);
  await Promise.all(old.map((name) => caches.delete(name)));
}

interface ExtendableEvent extends Event {
  waitUntil(work: Promise<unknown>): void;
}
interface FetchEvent extends Event {
  request: Request;
  respondWith(response: Promise<Response>): void;
}
