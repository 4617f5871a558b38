// n8ao in headless Chromium: its times and its pictures.
//
// Usage: node run.js REQUEST FOLDER     by tests/peers/peers.py, which says what is in either
import { build } from "esbuild";
import { readFile, writeFile } from "node:fs/promises";
import path from "node:path";
import { fileURLToPath } from "node:url";
import puppeteer from "puppeteer-core";

// ANGLE over the system's OpenGL, through EGL, which needs no display; Chromium's own would be SwiftShader.
// Without the watchdog, which would end frames that take many seconds, as those of 3840x2160 may.
const OPENGL = ["--use-gl=angle", "--use-angle=gl-egl", "--ignore-gpu-blocklist", "--disable-gpu-watchdog"];
// One of the calls draws dozens of frames.
const PATIENCE = 3600e3;

const [requestFile, folder] = process.argv.slice(2);
const request = JSON.parse(await readFile(requestFile));
const here = path.dirname(fileURLToPath(import.meta.url));

async function pageOf(browser) {
  const page = await browser.newPage();
  page.on("pageerror", error => console.error(`n8ao: ${error.message}`));
  page.on("console", message => { if (message.type() === "error") console.error(`n8ao: ${message.text()}`); });
  const bundle = await build({ entryPoints: [path.join(here, "page.js")], bundle: true, format: "iife", write: false });
  await page.addScriptTag({ content: bundle.outputFiles[0].text });
  return page;
}

const save = (name, base64) => writeFile(path.join(folder, name), Buffer.from(base64, "base64"));

/// Lists of milliseconds, "with" and "without" the pass, for each name.
async function timesOf(page) {
  const times = {};
  for (let run = 0; run < request.warm_up + request.runs; ++run) {
    const frames = await page.evaluate(() => window.time());
    if (run < request.warm_up) continue;
    for (const [name, frame] of Object.entries(frames)) {
      times[name] ??= { without: [], with: [] };
      for (const [way, milliseconds] of Object.entries(frame)) times[name][way].push(milliseconds);
    }
  }
  return times;
}

async function measure(page) {
  const glb = await readFile(request.scene, "base64");
  const { renderer, samples, settings } = await page.evaluate((...both) => window.start(...both), glb, request);
  if (!renderer.includes(request.renderer))
    throw new Error(`Chromium draws with '${renderer}', not with ${request.renderer}; install libgl1-mesa-dri.`);
  const results = [];
  for (const [name, frames_ms] of Object.entries(await timesOf(page))) {
    const picture = `${name}.f32`;
    await save(picture, await page.evaluate(name => window.picture(name), name));
    results.push({ name, samples, picture, frames_ms });
  }
  const converged = "n8ao-converged.f32";
  await save(converged, await page.evaluate(() => window.converged()));
  return { renderer, results, converged, settings };
}

async function main() {
  const browser = await puppeteer.launch({
    executablePath: request.chromium, protocolTimeout: PATIENCE,
    // Chromium has no sandbox for root.
    args: [...OPENGL, ...(process.getuid() === 0 ? ["--no-sandbox"] : [])],
  });
  try {
    const result = await measure(await pageOf(browser));
    const { n8ao, three } = JSON.parse(await readFile(path.join(here, "package.json"))).dependencies;
    result.versions = { n8ao, three, browser: await browser.version() };
    await writeFile(path.join(folder, "result.json"), JSON.stringify(result));
  } finally {
    await browser.close();
  }
}

main().catch(error => {
  console.error(`n8ao: ${error.message}`);
  process.exitCode = 1;
});
