// Typesets LaTeX as MathML: a JSON list of { latex, display } on the input, a list of MathML on the output.
import temml from "temml";
import { readFileSync } from "node:fs";

// Brackets around what is no higher than they are do not grow: grown ones come with gaps. A name needs none before its bracket.
const LOW = /\\left\(((?:(?!\\left|\\right|\\frac|\\sqrt|\^).)*?)\s*\\right\)/g;
const GAP = /(<mo>\u2061<\/mo>)<mspace width="0.1667em"><\/mspace>(<\/mrow>(?:<mrow>)?<mo [^>]*>\()/g;

const snippets = JSON.parse(readFileSync(0, "utf8"));
const typeset = snippets.map(({ latex, display }) =>
  temml.renderToString(latex.replace(LOW, "($1)"), { displayMode: display, throwOnError: true, wrap: "none" }).replace(GAP, "$1$2"),
);
process.stdout.write(JSON.stringify(typeset));
