/** A question in the address: `#quantity=…&formula=…&given=…&let=…&latex=1`, percent-encoded. */

import type { Notation, Question } from "./question";

export function toLink(question: Question): string {
  const parts = [
    ["quantity", question.quantity],
    ["formula", question.formula],
    ...Object.entries(question.given).map(([name, value]) => ["given", `${name}=${value}`]),
    ...Object.entries(question.let).map(([name, value]) => ["let", `${name}=${value}`]),
    question.notation === "latex" ? ["latex", "1"] : ["latex", ""],
    question.notation === "python" ? ["code", "python"] : ["code", ""],
  ];
  return `#${parts.filter(([, value]) => value).map(([name, value]) => `${name}=${encodeURIComponent(value ?? "")}`).join("&")}`;
}

/** The question in an address; null where there is none. A plus sign is a plus sign. */
export function fromLink(hash: string): Question | null {
  const found: Question = { quantity: "", formula: "", notation: "text", given: {}, let: {} };
  for (const part of hash.replace(/^#/, "").split("&")) {
    const [name, value] = split(part);
    const text = decoded(value);
    if (name === "quantity" || name === "formula") found[name] = text;
    else if (name === "latex" && text && text !== "0") found.notation = "latex";
    else if (name === "code" && text) found.notation = text as Notation;
    else if (name === "given" || name === "let") Object.assign(found[name], pairs(text));
  }
  return found.formula || found.quantity ? found : null;
}

/** `rho=0`, or several with commas, semicolons or line ends between them. */
function pairs(text: string): Record<string, string> {
  const lines = text.split(/[;\n]|,(?=\s*\w+\s*=[^=])/).map(split);
  return Object.fromEntries(lines.map(([name, value]) => [name.trim(), value.trim()]).filter(([name]) => name));
}

function split(text: string): [string, string] {
  const at = text.indexOf("=");
  return at < 0 ? [text, ""] : [text.slice(0, at), text.slice(at + 1)];
}

function decoded(text: string): string {
  try {
    return decodeURIComponent(text);
  } catch {
    return text; // a lone percent sign
  }
}
