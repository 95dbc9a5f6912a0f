/** A claims file: every claim decided, one after the other, with progress and a report. */

import { type Engine, Stopped, TooLong } from "./engine";
import { byId, element, save } from "./elements";
import type { Claims, Failure, Verdict } from "./question";
import { Details } from "./verdict";

const MOST_BYTES = 1_000_000;
const WRONG = ["differs", "wrong_dimensions"];
const WORDS: Record<Verdict["verdict"], string> = {
  equal: "equal",
  equal_numerically: "equal, not proved",
  differs: "differs",
  wrong_dimensions: "wrong dimensions",
  undecided: "undecided",
};

export class Paper {
  readonly #box = byId("paper");

  constructor(
    private readonly engine: Engine,
    private readonly say: (text: string, kind: string) => void,
  ) {}

  async audit(file: { name: string; size: number; text(): Promise<string> }): Promise<void> {
    if (file.size > MOST_BYTES) {
      this.say(`cannot read: ${file.name} has more than a million bytes`, "undecided");
      return;
    }
    this.say(`Reading ${file.name} …`, "working");
    const read = await this.engine.ask<Claims | Failure>({ ask: "claims", text: await file.text() });
    if ("error" in read) {
      this.say(`cannot read: ${file.name}: ${read.error}`, "undecided");
      return;
    }
    await this.#decide(file.name, read);
  }

  async #decide(name: string, { paper, claims, files }: Claims): Promise<void> {
    const progress = element("progress", { max: String(claims.length), value: "0", "aria-label": "claims decided" });
    const counted = element("p", { class: "hint" });
    const list = element("ol", { class: "claims" });
    this.#box.replaceChildren(element("h3", {}, paper), progress, counted, list);
    this.#box.hidden = false;
    const verdicts: Verdict[] = [];
    for (const [place, claim] of claims.entries()) {
      counted.textContent = `${place} of ${claims.length} claims; now ${claim.id}`;
      try {
        verdicts.push(await this.#one(claim, files));
      } catch (error) {
        if (!(error instanceof Stopped)) throw error;
        this.say(`stopped after ${place} of ${claims.length} claims`, "undecided");
        break;
      }
      progress.value = place + 1;
      const last = verdicts.at(-1);
      if (last) list.append(row(last));
    }
    progress.remove();
    await this.#report(name, paper, verdicts, counted, verdicts.length === claims.length);
  }

  async #one(claim: Claims["claims"][number], files: unknown[]): Promise<Verdict> {
    try {
      return told(claim, await this.engine.ask<Verdict | Failure>({ ask: "decide", claim, files }));
    } catch (error) {
      if (!(error instanceof TooLong)) throw error;
      const known = error.known as Verdict | null;
      if (!known) return told(claim, { error: "cannot decide in 20 s" });
      return { ...known, remarks: [...known.remarks, "what else is said beside a verdict was not found in time"] };
    }
  }

  async #report(name: string, paper: string, verdicts: Verdict[], counted: HTMLElement, isWhole: boolean): Promise<void> {
    const audits = [{ paper, file: name, claims: verdicts }];
    const { html, summary } = await this.engine.ask<{ html: string; summary: string }>({ ask: "report", audits });
    if (isWhole) this.say(summary, verdicts.some((one) => WRONG.includes(one.verdict)) ? "differs" : "equal");
    const base = name.replace(/\.toml$/, "");
    counted.replaceChildren(
      `${summary}. `,
      element("button", { type: "button", click: () => save(`${base}.html`, "text/html", html) }, "Save the report"),
      " ",
      element(
        "button",
        { type: "button", click: () => save(`${base}.json`, "application/json", JSON.stringify({ papers: audits }, null, 1)) },
        "Save as JSON",
      ),
    );
  }
}

/** A verdict, or that there is none. */
function told(claim: Claims["claims"][number], answer: Verdict | Failure): Verdict {
  if (!("error" in answer)) return answer;
  return {
    ...claim,
    verdict: "undecided",
    printed: "",
    derived: "",
    reason: answer.error,
    headline: "cannot decide",
    rest: `: ${answer.error}`,
    said: [],
    at_worst: "",
    counterexample: null,
    suggestions: [],
    remarks: [],
    conditions: [],
    note: "",
  };
}

function row(verdict: Verdict): HTMLElement {
  const box = element("div", {});
  new Details(box, null, null, null).show(verdict);
  const where = [verdict.equation, verdict.page && `p. ${verdict.page}`].filter(Boolean).join(", ");
  return element(
    "li",
    {},
    element(
      "details",
      { class: verdict.verdict },
      element(
        "summary",
        {},
        element("span", { class: "id" }, verdict.id),
        " ",
        element("strong", { class: "word" }, WORDS[verdict.verdict]),
        ` ${where} `,
        element("code", {}, verdict.quantity),
      ),
      element("p", {}, verdict.reason),
      box,
      verdict.note && verdict.note !== verdict.printed ? element("p", { class: "hint" }, verdict.note) : null,
    ),
  );
}
