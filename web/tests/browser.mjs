// A Chromium with an empty profile, and pages whose complaints are kept.
import { existsSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

export const CHROMIUM = process.env.CHROMIUM ?? "/usr/bin/chromium";
export const SITE = process.env.SITE ?? fileURLToPath(new URL("../../build/site", import.meta.url));
export const MISSING = !existsSync(CHROMIUM)
  ? `${CHROMIUM} is not there; CHROMIUM=… names another`
  : !existsSync(join(SITE, "check", "index.html"))
    ? `${SITE} is not built; make site does`
    : "";
const FLAGS = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
  "--disable-background-networking", "--disable-component-update", "--disable-sync"];

export async function open(options = {}) {
  const { chromium } = await import("playwright-core");
  const profile = mkdtempSync(join(tmpdir(), "radartrack-profile-"));
  const context = await chromium.launchPersistentContext(profile, {
    executablePath: CHROMIUM, args: FLAGS, chromiumSandbox: false, acceptDownloads: true, ...options,
  });
  context.setDefaultTimeout(Number(process.env.PATIENCE ?? 120_000));
  return {
    context,
    close: async () => {
      await context.close();
      rmSync(profile, { recursive: true, force: true });
    },
  };
}

/** A page, and what it complained of: errors, warnings, requests to other hosts. */
export async function page(context, address) {
  const made = await context.newPage();
  await made.addInitScript((patience) => (globalThis.PATIENCE = patience), Number(process.env.SLOW ?? 5));
  const complaints = [];
  made.on("console", (message) => {
    if (["error", "warning"].includes(message.type())) complaints.push(message.text());
  });
  made.on("response", (response) => {
    if (response.status() >= 400) complaints.push(`${response.status()} ${response.url()}`);
  });
  made.on("pageerror", (error) => complaints.push(String(error)));
  made.on("request", (request) => {
    if (!/^(data|blob):/.test(request.url()) && !request.url().startsWith(address)) complaints.push(`asked ${request.url()}`);
  });
  return Object.assign(made, { complaints });
}
