/** What is asked, and what the library answers. */

export type Notation = "text" | "latex" | "python";

export interface Question {
  quantity: string;
  formula: string;
  notation: Notation;
  given: Record<string, string>;
  let: Record<string, string>;
}

export interface Counterexample {
  point: Record<string, number>;
  entry: number[];
  printed: number | null;
  derived: number;
  relative_difference: number | null;
}

export interface Suggestion {
  formula: string;
  edit: string;
  entry: number[];
  proved: boolean;
  definition: string;
  applied: { text?: string; latex?: string; quantity?: string; let?: Record<string, string> };
}

/** What is known of one claim, in the fields of the command line's JSON and in words. */
export interface Verdict {
  id: string;
  verdict: "equal" | "equal_numerically" | "differs" | "wrong_dimensions" | "undecided";
  quantity: string;
  printed: string;
  derived: string;
  reason: string;
  headline: string;
  rest: string;
  said: [string, string][];
  at_worst: string;
  counterexample: Counterexample | null;
  suggestions: Suggestion[];
  remarks: string[];
  conditions: string[];
  equation: string;
  page: string;
  note: string;
  printed_mathml?: string;
  derived_mathml?: string;
  suggestions_mathml?: string[];
  unreadable?: boolean;
}

export interface Symbol {
  name: string;
  mathml: string;
  meaning: string;
  unit: string;
  value: number;
  low: number;
  high: number;
}

export interface Values {
  entry: number[];
  symbols: Symbol[];
  printed: number | null;
  derived: number | null;
  relative_difference: number | null;
}

export interface Found {
  quantity: string;
  meaning: string;
  given: Record<string, string>;
  convention: string;
  read: Record<string, string>;
  formula: string;
  mathml: string;
  words: string;
}

export interface Claims {
  paper: string;
  files: unknown[];
  claims: { id: string; equation: string; page: string; quantity: string }[];
}

export interface Failure {
  error: string;
  message?: string;
  span?: [number, number];
}

/** The notation that a formula looks written in. */
export function looksLike(formula: string): Notation {
  if (/\\[a-zA-Z]|[_^]\{|\$/.test(formula)) return "latex";
  if (/\b(np|math|numpy)\.|\bdef \w|\breturn\b|^\s*\w+\s*=[^=]/m.test(formula)) return "python";
  return "text";
}
