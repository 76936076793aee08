// Draws the scene's layers with WebGL 1, which every browser with any WebGL has.

const kColours = {
  surface: [186, 200, 222],
  inside: [207, 97, 92],
  wireframe: [70, 84, 106],
  wireframeAlone: [112, 132, 164],
  points: [38, 108, 190],
  emst: [232, 128, 20],
  egh: [60, 160, 100],
  hidden: [214, 40, 190],
};

const rgb = (colour) => colour.map((c) => c / 255);

class Renderer {
  /** Throws an Error that says what is missing. */
  constructor(canvas, scene, surface) {
    this.canvas = canvas;
    this.scene = scene;
    this.surface = surface;
    this.gl = canvas.getContext("webgl", { antialias: true, alpha: true });
    if (!this.gl) throw new Error("This browser has no WebGL, or has it switched off.");
    this.setUp();
  }

  /** Makes all that lives on the graphics processor, anew where the context was lost. */
  setUp() {
    const { gl, scene } = this;
    for (const name of ["OES_element_index_uint", "OES_standard_derivatives"]) {
      if (!gl.getExtension(name)) throw new Error(`This browser's WebGL lacks ${name}.`);
    }
    this.faces = makeProgram(gl, kFaceVertexShader, kFaceFragmentShader);
    this.lines = makeProgram(gl, kMarkVertexShader, kLineFragmentShader);
    this.dots = makeProgram(gl, kMarkVertexShader, kDotFragmentShader);
    this.positions = this.filled(gl.ARRAY_BUFFER, scene.positions);
    this.emst = this.filled(gl.ELEMENT_ARRAY_BUFFER, scene.emst);
    this.egh = this.filled(gl.ELEMENT_ARRAY_BUFFER, scene.egh);
    this.normals = gl.createBuffer();
    this.triangles = gl.createBuffer();
    this.edges = gl.createBuffer();
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
    this.takeSurface();
  }

  filled(kind, array) {
    const buffer = this.gl.createBuffer();
    this.gl.bindBuffer(kind, buffer);
    this.gl.bufferData(kind, array, this.gl.STATIC_DRAW);
    return buffer;
  }

  /** Brings the surface as it is now to the graphics processor; its edges only once they are drawn. */
  takeSurface() {
    const { gl, surface } = this;
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.triangles);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, surface.corners(), gl.DYNAMIC_DRAW);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.normals);
    gl.bufferData(gl.ARRAY_BUFFER, surface.normals, gl.DYNAMIC_DRAW);
    this.edgeEnds = null;
  }

  takeEdges() {
    const { gl } = this;
    const edges = this.surface.edges();
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.edges);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, edges, gl.DYNAMIC_DRAW);
    this.edgeEnds = edges.length;
  }

  /** `shown` says for each layer whether it is on. */
  draw(camera, shown) {
    const { gl, scene } = this;
    if (gl.isContextLost()) return;
    this.camera = camera;
    this.pixelRatio = this.canvas.width / camera.width;
    gl.viewport(0, 0, this.canvas.width, this.canvas.height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.POLYGON_OFFSET_FILL);
    if (shown.surface) this.drawSurface(shown.smooth);
    if (shown.egh) this.drawEgh();
    gl.disable(gl.POLYGON_OFFSET_FILL);
    if (shown.wireframe) {
      if (this.edgeEnds === null) this.takeEdges();
      const colour = shown.surface ? kColours.wireframe : kColours.wireframeAlone;
      this.drawLines(this.edges, this.edgeEnds, colour);
    }
    if (shown.emst) this.drawLines(this.emst, scene.emst.length, kColours.emst);
    if (shown.points) this.drawPoints();
    if (shown.hidden && scene.hiddenCount > 0) this.drawHidden();
  }

  use({ program, at }) {
    const { gl, camera } = this;
    gl.useProgram(program);
    gl.uniformMatrix4fv(at.view, false, camera.view());
    gl.uniformMatrix4fv(at.projection, false, camera.projection());
    gl.bindBuffer(gl.ARRAY_BUFFER, this.positions);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
    gl.disableVertexAttribArray(1);
    return at;
  }

  drawSurface(smooth) {
    const { gl } = this;
    const at = this.use(this.faces);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.normals);
    gl.enableVertexAttribArray(1);
    gl.vertexAttribPointer(1, 3, gl.FLOAT, false, 0, 0);
    gl.uniform3fv(at.front, rgb(kColours.surface));
    gl.uniform3fv(at.back, rgb(kColours.inside));
    gl.uniform1f(at.smoothness, smooth ? 1 : 0);
    // The inside gives way to the outside, which it meets at silhouettes and where tetrahedra are flat.
    // From outside a closed surface nothing is seen of it.
    const sides = [[gl.BACK, 2], [gl.FRONT, 12]].slice(0, this.camera.isOutside() ? 1 : 2);
    gl.enable(gl.CULL_FACE);
    for (const [culled, offset] of sides) {
      gl.cullFace(culled);
      gl.polygonOffset(offset, offset);
      this.drawElements(gl.TRIANGLES, this.triangles, 3 * this.surface.count);
    }
    gl.disable(gl.CULL_FACE);
  }

  /** In front of the surface, most of whose triangles are of the graph. */
  drawEgh() {
    const { gl } = this;
    const at = this.use(this.faces);
    gl.uniform3fv(at.front, rgb(kColours.egh));
    gl.uniform3fv(at.back, rgb(kColours.egh));
    gl.uniform1f(at.smoothness, 0);
    gl.polygonOffset(1, 1);
    this.drawElements(gl.TRIANGLES, this.egh, this.scene.egh.length);
  }

  drawLines(buffer, ends, colour) {
    const at = this.use(this.lines);
    this.setMark(at, colour, [1, 1, 1], 0.0004);
    this.drawElements(this.gl.LINES, buffer, ends);
  }

  /** As large as the points' mean distance allows. */
  drawPoints() {
    const { gl, scene, camera, pixelRatio } = this;
    const at = this.use(this.dots);
    const size = (0.7 * camera.focalLength() * camera.radius) / Math.sqrt(scene.pointCount + 1);
    this.setMark(at, kColours.points, [size, 2, 7].map((x) => x * pixelRatio), 0.0006);
    gl.drawArrays(gl.POINTS, 0, scene.pointCount);
  }

  /** Through everything: they lie inside. */
  drawHidden() {
    const { gl, scene, pixelRatio } = this;
    const at = this.use(this.dots);
    this.setMark(at, kColours.hidden, [11, 11, 11].map((x) => x * pixelRatio), 0);
    gl.disable(gl.DEPTH_TEST);
    gl.drawArrays(gl.POINTS, scene.pointCount, scene.hiddenCount);
    gl.enable(gl.DEPTH_TEST);
  }

  setMark(at, colour, size, forward) {
    const { gl } = this;
    gl.uniform4fv(at.colour, [...rgb(colour), 1]);
    gl.uniform3fv(at.size, size);
    gl.uniform1f(at.forward, forward);
  }

  drawElements(kind, buffer, count) {
    const { gl } = this;
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, buffer);
    gl.drawElements(kind, count, gl.UNSIGNED_INT, 0);
  }
}
