// Runs in the page of viser's client, before it: lets points have a size in pixels, whatever their distance, draws edges
// without smoothing where there is no graphics card, and tells the server what has been drawn.
//
// Viser's points have a size in metres alone, by one line of its shader. A size below zero means here thousandths of a
// pixel of the page; the shader gets the size of a pixel with each drawing of points, because a window may be resized
// at any time. A browser without WebGL 2 shows no scene anyway. `viser_private.py` has the line, too, and looks for it.
"use strict";
if (window.WebGL2RenderingContext) {
  const IN_METRES = "gl_PointSize = (scale / -world_pos.z);";
  const NAME = "tfloom_thousand_by_height";
  const IN_BOTH = `gl_PointSize = scale < 0.0 ? -scale / projectionMatrix[1][1] * ${NAME} : scale / -world_pos.z;`;
  const context = WebGL2RenderingContext.prototype;
  const { shaderSource, drawArrays } = context;
  const places = new WeakMap();  // of the uniform in each program; null in one that has none

  context.shaderSource = function (shader, source) {
    const changed = source.includes(IN_METRES)
      ? source.replace(IN_METRES, IN_BOTH).replace("void main()", `uniform float ${NAME};\nvoid main()`) : source;
    shaderSource.call(this, shader, changed);
  };
  context.drawArrays = function (mode, first, count) {
    if (mode === this.POINTS) {
      const program = this.getParameter(this.CURRENT_PROGRAM);
      if (!places.has(program)) places.set(program, this.getUniformLocation(program, NAME));
      // Viser's scale is the size by the height of the picture in pixels of the card, of which one of the page has several.
      if (places.get(program)) this.uniform1f(places.get(program), 1000.0 / Math.max(1, this.canvas.clientHeight));
    }
    drawArrays.call(this, mode, first, count);
  };

  // Without a card, smoothed edges take most of the time of a picture. A browser may refuse a context that must be a fast
  // one, or names what draws: SwiftShader in Chromium, llvmpipe of Mesa, Windows' Basic Render Driver.
  const isWithoutCard = () => {
    const probe = document.createElement("canvas").getContext("webgl2", { failIfMajorPerformanceCaveat: true });
    if (!probe) return true;
    const names = probe.getExtension("WEBGL_debug_renderer_info");
    const drawer = probe.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : probe.RENDERER);
    const lose = probe.getExtension("WEBGL_lose_context");
    if (lose) lose.loseContext();  // of contexts, a page has few
    return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(drawer);
  };
  if (isWithoutCard()) {
    const { getContext } = HTMLCanvasElement.prototype;
    HTMLCanvasElement.prototype.getContext = function (kind, options) {
      return getContext.call(this, kind, kind === "webgl2" ? { ...options, antialias: false } : options);
    };
  }
}

// The server sends no more than a page can draw: it waits until it has heard that what came before was drawn. Viser's
// client takes messages by a worker, and draws what has come with the next picture; the one after that begins when this
// one is done. Pages that are not seen draw nothing, and take all that comes.
const OwnWorker = window.Worker;
window.Worker = class extends OwnWorker {
  constructor(...given) {
    super(...given);
    let taken = 0, said = 0;
    const say = (count) => {
      if (count <= said) return;
      said = count;
      this.postMessage({ type: "send", message: { type: "TfloomDrawn", count } });
    };
    this.addEventListener("message", ({ data }) => {
      if (!data) return;
      if (data.type === "connected") taken = said = 0;
      if (data.type !== "message_batch") return;
      const count = (taken += 1);
      if (document.hidden) say(count);
      else requestAnimationFrame(() => requestAnimationFrame(() => say(Math.min(count, taken))));
    });
    document.addEventListener("visibilitychange", () => { if (document.hidden && taken) say(taken); });
  }
};
