// The checker's page in Chromium: what is typed, pasted, linked, dropped, without a network, and by somebody hostile.
import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { MISSING, SITE, open, page } from "./browser.mjs";
import { serve } from "./serving.mjs";

const ESTIMATE = { quantity: "polar.unbiased.estimate[0]", formula: "r*cos(beta)*(1 - sigma_beta^2/2)", given: "rho=0" };
const RIGHT = "\\tfrac12\\left(\\sigma_r^2-r^2\\sigma_\\theta^2\\right)\\sin 2\\theta";
const skip = MISSING || false;
const link = (parts) => "#" + Object.entries(parts).map(([name, value]) => `${name}=${encodeURIComponent(value)}`).join("&");

let site, browser, one;

if (skip) console.log(`# the site is not tested: ${skip}`);
before(async () => {
  if (skip) return;
  site = await serve(SITE);
  browser = await open();
  one = await page(browser.context, site.address);
});
after(async () => {
  await browser?.close();
  await site?.close();
});

/** Asks until it is so; Playwright's own waiting takes a promise for an answer. */
async function until(asked) {
  for (let tries = 0; !(await asked()); tries++) {
    assert.ok(tries < 1200, `never so: ${asked}`);
    await new Promise((over) => setTimeout(over, 100));
  }
}
const verdict = (at = one) => at.getByRole("status");
async function settled(expected, at = one) {
  await at.waitForFunction((text) => document.querySelector("[role=status]").textContent.match(new RegExp(text)), expected);
  return verdict(at).textContent();
}
/** The verdict of a link, with all that is said beside it. */
async function linked(parts, expected, at = one) {
  await at.goto(`${site.address}/check/${link(parts)}`);
  const told = await settled(expected, at);
  await at.locator("#stop").waitFor({ state: "hidden" });
  return told;
}

test("a link opens to its verdict, and what was meant is one click away", { skip }, async () => {
  await linked(ESTIMATE, "^differs");
  assert.equal(await one.getByRole("status").count(), 1);
  assert.match(await one.locator("#details").textContent(), /Perhaps meant/);
  assert.ok(await one.locator("#details .part").first().locator(".different").count(), "the wrong term stands out");
  await one.getByRole("button", { name: "Put it in" }).first().click();
  assert.match(await settled("^equal"), /proved when rho = 0/);
  assert.match(decodeURIComponent(one.url()), /exp\(sigma_beta\*\*2\/2\)/);
});

test("numbers of the counterexample can be changed", { skip }, async () => {
  await linked(ESTIMATE, "^differs");
  const compared = one.locator(".compared");
  const first = await compared.textContent();
  assert.match(first, /printed 41817\.4\s*derived 44810\.9/);
  await one.locator(".numbers input").first().fill("100000");
  await one.waitForFunction((before) => document.querySelector(".compared").textContent !== before, first);
  assert.match(await compared.textContent(), /printed 83634\.\d\s*derived 89621\.\d/);
});

test("LaTeX is seen as such, typeset as it was read, and proved with its letters", { skip }, async () => {
  await one.goto(`${site.address}/check/`);
  await one.locator("#formula").fill(RIGHT);
  await one.locator("#reading math").waitFor();
  await one.locator("#quantity").fill("polar.covariance.linear[0,1]");
  await one.locator("#more summary").click();
  await one.getByLabel("condition: name").first().fill("rho");
  await one.getByLabel("condition: value").first().fill("0");
  await one.getByRole("button", { name: "Check", exact: true }).click();
  assert.match(await settled("^equal"), /proved when rho = 0/);
  await one.locator("#stop").waitFor({ state: "hidden" });
  assert.match(await one.locator("#details").textContent(), /theta for beta/);
  const address = await one.locator("#link").inputValue();
  assert.match(address, /latex=1/);
  await one.goto("about:blank");
  await one.goto(address);
  assert.match(await settled("^equal"), /proved when rho = 0/);
});

test("what is pasted is checked with the keyboard alone", { skip }, async () => {
  await one.goto(`${site.address}/check/`);
  await one.locator("#formula").focus();
  await one.keyboard.insertText("-D*r*cos(beta)/2");
  await one.locator("#quantity").focus();
  await one.keyboard.insertText("polar.bias.second_order[0]");
  await one.keyboard.press("Escape");
  await one.locator("#more summary").focus();
  await one.keyboard.press("Enter");
  await one.getByLabel("condition: name").first().focus();
  await one.keyboard.insertText("rho");
  await one.keyboard.press("Tab");
  await one.keyboard.insertText("0");
  await one.getByLabel("definition: name").first().focus();
  await one.keyboard.insertText("D");
  await one.keyboard.press("Tab");
  await one.keyboard.insertText("sigma_beta^2");
  await one.keyboard.press("Enter");
  assert.match(await settled("^(equal|differs)"), /^equal/);
});

test("a quantity is found by words, with the arrow keys, and by its formula", { skip }, async () => {
  await one.goto(`${site.address}/check/`);
  await one.locator("#quantity").fill("debiased covariance");
  await one.waitForFunction(() => /covariance\.averaged/.test(document.querySelector("#quantities li")?.textContent));

  await one.keyboard.press("ArrowDown");
  await one.keyboard.press("Enter");
  assert.match(await one.locator("#quantity").inputValue(), /^\w+\.covariance\./);
  assert.match(await one.locator("#meant").textContent(), /ovariance/);
  await one.locator("#quantity").fill("");
  await one.locator("#formula").fill("r*cos(beta)");
  await one.getByRole("button", { name: "Find it for me" }).click();
  assert.match(await settled("^found"), /map\[0\]/);
  await one.locator("#stop").waitFor({ state: "hidden" });
  await one.getByRole("button", { name: "Check against this" }).first().click();
  await settled("^equal");
});

test("a claims file that is dropped is audited, with a report to keep", { skip }, async () => {
  await one.goto(`${site.address}/check/`);
  const text = `paper = "Smith, <b>Radar</b>"
[[claim]]
id = "s.1"
quantity = "polar.map[0]"
formula = "r*cos(beta)"
[[claim]]
id = "s.2"
quantity = "polar.map[1]"
formula = "r*cos(beta)"
[[claim]]
id = "s.3"
quantity = "polar.map[1]"
formula = "r*("
`;
  const handle = await one.evaluateHandle((content) => {
    const data = new DataTransfer();
    data.items.add(new File([content], "smith.toml"));
    return data;
  }, text);
  await one.dispatchEvent("body", "dragover", { dataTransfer: handle });
  assert.ok(await one.locator("#drop").isVisible());
  await one.dispatchEvent("body", "drop", { dataTransfer: handle });
  assert.match(await settled("3 claims"), /1 equal, 1 differs, 1 undecided/);
  assert.equal(await one.locator(".claims > li").count(), 3);
  const [download] = await Promise.all([one.waitForEvent("download"), one.getByRole("button", { name: "Save the report" }).click()]);
  const report = readFileSync(await download.path(), "utf8");
  assert.match(report, /Smith, &lt;b&gt;Radar/);
  assert.match(report, /<math/);
});

test("a file that is no claims file is refused in words", { skip }, async () => {
  const folder = mkdtempSync(join(tmpdir(), "radartrack-"));
  const path = join(folder, "no.toml");
  writeFileSync(path, "this is no TOML");
  await one.goto(`${site.address}/check/`);
  await one.locator("#file").setInputFiles(path);
  assert.match(await settled("cannot read"), /not TOML/);
});

test("hostile formulas do nothing but be refused", { skip }, async () => {
  const hostile = [
    "<script>document.title='owned'</script>",
    "<img src=x onerror=document.title='owned'>",
    "__import__('os').system('x')",
    "\\href{javascript:alert(1)}{r}",
    "r**(9**9**9**9)",
    "(".repeat(3000) + "r" + ")".repeat(3000),
    "sum(sum(sum(r**a, a, 1, 10**9), b, 1, 10**9), c, 1, 10**9)",
  ];
  for (const formula of hostile) {
    await one.goto("about:blank");
    const told = await linked({ quantity: "polar.map[0]", formula, latex: formula.includes("\\") ? "1" : "" }, "^(cannot|differs|wrong|stopped)");
    assert.ok(told.length > 5, formula.slice(0, 40));
    assert.notEqual(await one.title(), "owned");
    assert.equal(await one.locator("#details script, #details img, #reading script, #reading img").count(), 0);
  }
  await linked({ quantity: "polar.map[0]", formula: "r*cos(beta)" }, "^equal");
});

test("a name of no quantity is answered with names that there are", { skip }, async () => {
  assert.match(await linked({ quantity: "polar.mapp", formula: "r" }, "^cannot read"), /polar\.map/);
});

test("a check that takes long is stopped, and the next one is answered", { skip }, async () => {
  await one.goto("about:blank");
  await one.goto(`${site.address}/check/${link({ quantity: "ruv.covariance.averaged.fourth_order", formula: "[[u*r, v, 1], [v, u, r], [1, r, u]]" })}`);
  await one.locator("#stop").click();
  assert.match(await settled("^(stopped|differs|wrong|cannot)"), /^(stopped|differs|wrong|cannot)/);
  await linked({ quantity: "polar.map[0]", formula: "r*cos(beta)" }, "^equal");
});

test("the formula editor writes LaTeX into the field", { skip }, async () => {
  await one.goto(`${site.address}/check/${link({ quantity: "polar.map[0]", formula: "r\\cos\\beta", latex: "1" })}`);
  await settled("^equal");
  await one.getByRole("button", { name: "Formula editor" }).click();
  const field = one.locator("math-field");
  await field.waitFor();
  await field.evaluate((node) => {
    node.executeCommand("moveToMathfieldEnd");
    node.insert("+1");
    node.dispatchEvent(new Event("input"));
  });
  assert.match(await one.locator("#formula").inputValue(), /\\cos.*\+1/s);
});

/** What a first page told of a right formula, and whether the modules were loaded for it. */
async function visited(context) {
  const visit = await page(context, site.address);
  let loaded = false;
  visit.on("request", (request) => (loaded ||= request.url().endsWith("modules.bin")));
  const told = await linked({ quantity: "polar.map[0]", formula: "r*cos(beta)" }, "^equal", visit);
  return { visit, told, loaded };
}
/** Cuts the memory that is kept to half of it, or leaves it; whether there is one. */
const kept = async (halve) => {
  const name = (await caches.keys()).find((one) => one.startsWith("radartrack-memory-"));
  const cache = name && (await caches.open(name));
  const [request] = cache ? await cache.keys() : [];
  if (!request) return false;
  const whole = await (await cache.match(request)).blob();
  if (halve) await cache.put(request, new Response(whole.slice(0, whole.size / 2)));
  return true;
};

test("what was loaded once is kept for the next visit, and loaded anew where it is damaged", { skip }, async () => {
  const own = await open();
  try {
    const first = await visited(own.context);
    assert.ok(first.loaded);
    await until(() => first.visit.evaluate(kept, false));
    await first.visit.close();
    const second = await visited(own.context);
    assert.ok(!second.loaded);
    assert.equal(second.told, first.told);
    assert.ok(await second.visit.evaluate(kept, true));
    await second.visit.close();
    const third = await visited(own.context);
    assert.ok(third.loaded);
    assert.equal(third.told, first.told);
    for (const { visit } of [first, second, third]) assert.deepEqual(visit.complaints, []);
  } finally {
    await own.close();
  }
});

test("the page works without a network after one visit, and asks no other host", { skip }, async () => {
  await one.goto(`${site.address}/check/`);
  await one.waitForFunction(() => document.getElementById("offline").textContent);
  await until(() =>
    one.evaluate(async () => {
      const name = (await caches.keys()).find((kept) => kept.startsWith("radartrack-check-"));
      return name && (await (await caches.open(name)).keys()).length > 10;
    }),
  );
  await site.close();
  try {
    const two = await page(browser.context, site.address);
    await two.goto(`${site.address}/check/${link(ESTIMATE)}`);
    assert.match(await settled("^differs", two), /not equal when rho = 0/);
    assert.deepEqual(two.complaints, []);
    await two.close();
  } finally {
    site = await serve(SITE, Number(new URL(site.address).port));
  }
});

test("nothing was complained of", { skip }, () => {
  assert.deepEqual(one.complaints, []);
});
