/** The library in a worker: asked one thing after the other, ended when it takes too long, started again. */

import type { Failure } from "./question";

const PATIENCE = (globalThis as { PATIENCE?: number }).PATIENCE ?? 1; // more on a machine that tests something else, too
const SECONDS = 20; // for a verdict
const EXPLANATION = 10; // of these, for what is said beside a verdict that is known
const START = 120; // for loading over a slow line

type Tell = (answer: never) => void;

interface Asked {
  request: object;
  tell: (answer: unknown) => void;
  done: (last: unknown) => void;
  last: unknown;
  until: number;
  explained: boolean;
}

/** When so many seconds will be over. */
const within = (seconds: number): number => performance.now() + 1000 * PATIENCE * seconds;

export class TooLong extends Error {
  constructor(readonly known: unknown) {
    super("it takes too long");
  }
}

export class Stopped extends Error {}

interface Said {
  id?: number;
  begun?: boolean;
  answer?: string;
  done?: boolean;
  state?: string;
  failed?: string;
}

export class Engine {
  #worker: Worker | null = null;
  #waiting = new Map<number, Asked & { fail: (error: Error) => void }>();
  #next = 1;
  #latest = Infinity;
  #timer = 0;
  #ready = false;

  constructor(private readonly onState: (state: string) => void) {}

  get ready(): boolean {
    return this.#ready;
  }

  start(): void {
    if (this.#worker) return;
    this.#worker = new Worker(new URL("worker.js", document.baseURI), { type: "module" });
    this.#worker.addEventListener("message", ({ data }: MessageEvent<Said>) => this.#heard(data));
    this.#worker.addEventListener("error", (event) => this.#broken(event.message || "the worker cannot be loaded"));
    this.#latest = within(START);
    this.#timer ||= window.setInterval(() => this.#watch(), 100);
  }

  /**
   * The last answer, which holds all that is known.
   *
   * @param tell takes each answer as it comes.
   * @param seconds for the first; what comes after it is given a few more.
   */
  ask<T>(request: object, tell: (answer: T) => void = () => {}, seconds = SECONDS): Promise<T> {
    this.start();
    const id = this.#next++;
    return new Promise<T>((resolve, reject) => {
      this.#waiting.set(id, {
        request: { ...request, seconds },
        tell: tell as Tell as (answer: unknown) => void,
        done: resolve as (last: unknown) => void,
        fail: reject,
        last: null,
        until: Infinity,
        explained: false,
      });
      this.#worker?.postMessage({ id, request: JSON.stringify(request) });
    });
  }

  /** Give up all that is asked. */
  stop(): void {
    const all = [...this.#waiting.values()];
    this.#waiting.clear();
    this.#restart();
    for (const one of all) one.fail(new Stopped("stopped"));
  }

  #heard({ id, begun, answer, done, state, failed }: Said): void {
    if (state) {
      this.#ready = state === "ready";
      this.onState(state);
    }
    if (failed) this.#broken(failed, id);
    const asked = id === undefined ? undefined : this.#waiting.get(id);
    if (!asked || id === undefined) return;
    if (begun) asked.until = within((asked.request as { seconds: number }).seconds);
    if (answer !== undefined) {
      asked.last = JSON.parse(answer);
      if (!asked.explained) asked.until = Math.min(asked.until, within(EXPLANATION));
      asked.explained = true;
      asked.tell(asked.last);
    }
    if (done) {
      this.#waiting.delete(id);
      asked.done(asked.last);
    }
  }

  #watch(): void {
    const now = performance.now();
    if (!this.#ready && this.#worker && now > this.#latest) this.#broken("Python did not start in time");
    for (const [id, asked] of this.#waiting) {
      if (now < asked.until) continue;
      this.#waiting.delete(id);
      asked.fail(new TooLong(asked.last));
      this.#restart();
      return;
    }
  }

  /** The worker ended by itself: what it was at fails, what waited is asked again. */
  #broken(why: string, id?: number): void {
    const began = id ?? [...this.#waiting].find(([, asked]) => asked.until < Infinity)?.[0];
    const asked = began === undefined ? undefined : this.#waiting.get(began);
    if (asked && began !== undefined) {
      this.#waiting.delete(began);
      asked.done(asked.last ?? ({ error: `This needs more than a browser allows: ${why}.` } satisfies Failure));
      this.#restart();
      return;
    }
    this.#end();
    this.onState(`failed: ${why}`);
    for (const one of this.#waiting.values()) one.done({ error: `Python cannot be started: ${why}.` } satisfies Failure);
    this.#waiting.clear();
  }

  #end(): void {
    this.#worker?.terminate();
    this.#worker = null;
    this.#ready = false;
  }

  #restart(): void {
    this.#end();
    this.start();
    for (const [id, asked] of this.#waiting) {
      asked.until = Infinity;
      this.#worker?.postMessage({ id, request: JSON.stringify(asked.request) });
    }
  }
}
