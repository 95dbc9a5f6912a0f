/** The memory of a Python that has loaded everything, kept by the browser, so that the next visit need not load it again. */

const PREFIX = "radartrack-memory-";
const PAGE = 65_536;

/** Kept under an address of its own, in a cache that is named after all that the memory holds. */
export class Memory {
  #address = new URL("python/memory", self.location.href).href;

  constructor(private readonly name: string) {}

  /** What an earlier visit kept. */
  async recall(): Promise<Uint8Array | null> {
    try {
      const body = (await (await this.#cache())?.match(this.#address))?.body;
      return body ? await bytes(body.pipeThrough(new DecompressionStream("gzip"))) : null;
    } catch {
      return null; // damaged, or a browser that keeps nothing
    }
  }

  /** Keep it for the next visit, instead of what an older page kept. A browser that has no room keeps nothing. */
  async keep(memory: Uint8Array): Promise<void> {
    try {
      const packed = new Blob([memory as BlobPart]).stream().pipeThrough(new CompressionStream("gzip"));
      await this.forget(); // first, for the room
      await (await this.#cache())?.put(this.#address, new Response(await new Response(packed).blob()));
    } catch {
      await this.forget();
    }
  }

  async forget(): Promise<void> {
    if (!("caches" in self)) return;
    const kept = (await caches.keys()).filter((name) => name.startsWith(PREFIX));
    await Promise.all(kept.map((name) => caches.delete(name)));
  }

  async #cache(): Promise<Cache | null> {
    return "caches" in self ? caches.open(PREFIX + this.name) : null;
  }
}

export async function bytes(stream: ReadableStream): Promise<Uint8Array> {
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Pyodide takes a memory up only when there is already room for it, and does not make room itself. */
export async function withRoomFor<T>(memory: Uint8Array | null, load: () => Promise<T>): Promise<T> {
  const { instantiateStreaming } = WebAssembly;
  const room = memory?.length ?? 0;
  WebAssembly.instantiateStreaming = async (source, imports) => {
    const made = await instantiateStreaming.call(WebAssembly, source, imports);
    const own = made.instance.exports["memory"];
    if (own instanceof WebAssembly.Memory) {
      own.grow(Math.max(0, Math.ceil((room - own.buffer.byteLength) / PAGE)));
    }
    return made;
  };
  try {
    return await load();
  } finally {
    WebAssembly.instantiateStreaming = instantiateStreaming;
  }
}
