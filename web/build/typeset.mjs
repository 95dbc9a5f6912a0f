// Typesets LaTeX as MathML: a JSON list of { latex, display } on the input, a list of MathML on the output.
import temml from "temml";
import { readFileSync } from "node:fs";

const snippets = JSON.parse(readFileSync(0, "utf8"));
const typeset = snippets.map(({ latex, display }) =>
  temml.renderToString(latex, { displayMode: display, throwOnError: true, wrap: "none" }),
);
process.stdout.write(JSON.stringify(typeset));
