/** Formulas as MathML: copied element by element, so that nothing but formulas can come in. */

const SPACE = "http://www.w3.org/1998/Math/MathML";
const ELEMENTS = new Set(
  "math mrow mi mn mo msup msub msubsup mfrac msqrt mtable mtr mtd mspace mtext mover munder munderover mstyle mpadded".split(" "),
);
const ATTRIBUTES = new Set(["class", "display", "fence", "form", "mathvariant", "stretchy", "width"]);

/** The formula, or null where there is none. */
export function typeset(mathml: string | undefined): Element | null {
  if (!mathml) return null;
  const parsed = new DOMParser().parseFromString(mathml, "application/xml");
  return copied(parsed.documentElement);
}

/** A formula in a box that scrolls by itself; its text where it cannot be typeset. */
export function formula(mathml: string | undefined, text: string): HTMLElement {
  const box = document.createElement("div");
  box.className = "formula";
  box.tabIndex = 0;
  box.setAttribute("role", "group");
  box.setAttribute("aria-label", "formula");
  const shown = typeset(mathml);
  if (shown) box.append(shown);
  else box.append(Object.assign(document.createElement("code"), { textContent: text }));
  return box;
}

function copied(node: Element): Element | null {
  if (!ELEMENTS.has(node.localName)) return null;
  const copy = document.createElementNS(SPACE, node.localName);
  for (const { name, value } of node.attributes) if (ATTRIBUTES.has(name)) copy.setAttribute(name, value);
  for (const child of node.childNodes) {
    if (child.nodeType === Node.TEXT_NODE) copy.append(child.textContent ?? "");
    else if (child instanceof Element) {
      const below = copied(child);
      if (below) copy.append(below);
    }
  }
  return copy;
}
