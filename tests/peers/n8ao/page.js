// What runs in the browser: n8ao at full and at half resolution on a scene, timed and drawn.
import { N8AOPass } from "n8ao";
import * as THREE from "three";
import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";

// Of the quality "Ultra": as many AO samples as mres takes, and n8ao's best denoising at those. "Neural" modes allow
// no smaller denoising radius than 12 pixels.
const QUALITY = "Ultra";
// n8ao accumulates 1024 samples a pixel, always the same ones; with another number of samples a frame they are others.
// The mean over these numbers has 4096.
const CONVERGED_SAMPLES = [64, 63, 62, 61];
const ACCUMULATED = 1024;

const bytesOf = base64 => Uint8Array.from(atob(base64), character => character.charCodeAt(0)).buffer;

function base64Of(floats) {
  const bytes = new Uint8Array(floats.buffer);
  let text = "";
  for (let start = 0; start < bytes.length; start += 0x8000)
    text += String.fromCharCode(...bytes.subarray(start, start + 0x8000));
  return btoa(text);
}

/// Surfaces are white and unlit, so that little besides the pass takes time. Holes of alpha masks stay.
function whiten(scene) {
  scene.traverse(object => {
    if (!object.isMesh) return;
    const { transparent, alphaTest, side, map } = object.material;
    object.visible = !transparent; // mres draws those after its effects
    object.material = new THREE.MeshBasicMaterial({ side, alphaTest, alphaMap: null, map: alphaTest > 0 ? map : null });
  });
}

function cameraOf(gltf, aspect) {
  const camera = gltf.cameras[0];
  if (camera.isPerspectiveCamera) {
    camera.aspect = aspect;
  } else {
    camera.right = camera.top * aspect;
    camera.left = -camera.right;
  }
  camera.updateProjectionMatrix();
  gltf.scene.updateMatrixWorld(true);
  return camera;
}

class Bench {
  constructor(gltf, { width, height, radius }) {
    this.size = { width, height };
    this.radius = radius;
    this.scene = gltf.scene;
    this.camera = cameraOf(gltf, width / height);
    this.renderer = new THREE.WebGLRenderer({ antialias: false });
    this.renderer.setSize(width, height, false);
    this.renderer.setClearColor(0xffffff, 1);
    this.target = new THREE.WebGLRenderTarget(width, height, { type: THREE.FloatType, depthBuffer: false });
  }

  /// `intensity` 1 is the share of open directions itself, as in mres; others take its power.
  pass(halfRes) {
    const pass = new N8AOPass(this.scene, this.camera, this.size.width, this.size.height);
    Object.assign(pass.configuration, { aoRadius: this.radius, distanceFalloff: 1, intensity: 1,
                                        gammaCorrection: false, halfRes });
    pass.setQualityMode(QUALITY);
    return pass;
  }

  /// Waits for the GPU by reading a pixel: gl.finish() is free to return at once.
  timed(draw, target, pixel) {
    const start = performance.now();
    draw();
    this.renderer.readRenderTargetPixels(target, 0, 0, 1, 1, pixel);
    return performance.now() - start;
  }

  timedWith(pass) {
    return this.timed(() => pass.render(this.renderer, this.target), this.target, new Float32Array(4));
  }

  /// The same scene into the same target, which n8ao goes on from.
  timedWithout(pass) {
    const draw = () => {
      this.renderer.setRenderTarget(pass.beautyRenderTarget);
      this.renderer.render(this.scene, this.camera);
    };
    return this.timed(draw, pass.beautyRenderTarget, new Uint16Array(4));
  }

  /// The ambient occlusion alone.
  values(pass) {
    pass.setDisplayMode("AO");
    pass.render(this.renderer, this.target);
    pass.setDisplayMode("Combined");
    return this.read();
  }

  /// What was drawn, one channel, rows from top to bottom.
  read() {
    const { width, height } = this.size;
    const pixels = new Float32Array(4 * width * height);
    this.renderer.readRenderTargetPixels(this.target, 0, 0, width, height, pixels);
    return Float32Array.from({ length: width * height },
                             (_, i) => pixels[4 * (width * (height - 1 - Math.floor(i / width)) + i % width)]);
  }

  /// Without the denoiser, which blurs.
  accumulated(aoSamples) {
    const pass = this.pass(false);
    Object.assign(pass.configuration, { aoSamples, denoiseIterations: 0, accumulate: true });
    pass.setDisplayMode("AO"); // before the first frame: a change would start anew
    for (let samples = 0; samples < ACCUMULATED; samples += aoSamples) pass.render(this.renderer, this.target);
    return this.read();
  }
}

let bench;
let passes;

/// Makes all ready to draw; tells who draws, and how.
window.start = async (glb, request) => {
  const gltf = await new GLTFLoader().parseAsync(bytesOf(glb), "");
  whiten(gltf.scene);
  bench = new Bench(gltf, request);
  passes = { "n8ao-full": bench.pass(false), "n8ao-half": bench.pass(true) };
  const gl = bench.renderer.getContext();
  const info = gl.getExtension("WEBGL_debug_renderer_info");
  return { renderer: gl.getParameter(info.UNMASKED_RENDERER_WEBGL),
           samples: passes["n8ao-full"].configuration.aoSamples,
           settings: { quality: QUALITY, converged_samples: ACCUMULATED * CONVERGED_SAMPLES.length } };
};

/// Milliseconds of a frame without and with each pass, drawn in turn.
window.time = () => Object.fromEntries(Object.entries(passes).map(([name, pass]) =>
  [name, { without: bench.timedWithout(pass), with: bench.timedWith(pass) }]));

window.picture = name => base64Of(bench.values(passes[name]));

window.converged = () => {
  const { width, height } = bench.size;
  const sum = new Float32Array(width * height);
  for (const samples of CONVERGED_SAMPLES)
    bench.accumulated(samples).forEach((value, i) => { sum[i] += value / CONVERGED_SAMPLES.length; });
  return base64Of(sum);
};
