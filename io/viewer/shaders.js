// The programs of the graphics processor.

const kFaceVertexShader = `
attribute vec3 position;
attribute vec3 normal;
uniform mat4 view;
uniform mat4 projection;
varying vec3 atEye;
varying vec3 smoothNormal;
void main() {
  vec4 p = view * vec4(position, 1.0);
  atEye = p.xyz;
  smoothNormal = mat3(view[0].xyz, view[1].xyz, view[2].xyz) * normal;
  gl_Position = projection * p;
}`;

// Lit as io/picture does. Across a crease, where the vertices' normals are far from the triangle's own,
// the latter counts. Where the surface bends away, inside and outside meet within a pixel: there the
// inside has the colour of the outside.
const kFaceFragmentShader = `
#extension GL_OES_standard_derivatives : enable
precision highp float;
uniform vec3 front;
uniform vec3 back;
uniform float smoothness;
varying vec3 atEye;
varying vec3 smoothNormal;
void main() {
  vec3 flatNormal = normalize(cross(dFdx(atEye), dFdy(atEye)));
  vec3 bent = smoothNormal * inversesqrt(max(dot(smoothNormal, smoothNormal), 1e-37));
  if (!gl_FrontFacing) bent = -bent;
  float share = smoothness * smoothstep(0.6, 0.8, dot(flatNormal, bent));
  vec3 n = normalize(mix(flatNormal, bent, share));
  float light = 0.25 + 0.45 * max(0.0, n.z) + 0.4 * max(0.0, dot(n, vec3(-0.48, 0.64, 0.6)));
  float inside = gl_FrontFacing ? 0.0 : smoothstep(0.05, 0.25, flatNormal.z);
  gl_FragColor = vec4(min(vec3(1.0), light * mix(front, back, inside)), 1.0);
}`;

// Lines and points come forward a little, so that they lie on the surface.
const kMarkVertexShader = `
attribute vec3 position;
uniform mat4 view;
uniform mat4 projection;
uniform float forward;
uniform vec3 size; // of a point one unit from the eye, its least and its largest, in pixels
void main() {
  vec4 p = view * vec4(position, 1.0);
  gl_Position = projection * vec4(p.xyz * (1.0 - forward), 1.0);
  gl_PointSize = clamp(size.x / -p.z, size.y, size.z);
}`;

const kLineFragmentShader = `
precision mediump float;
uniform vec4 colour;
void main() {
  gl_FragColor = colour;
}`;

const kDotFragmentShader = `
precision mediump float;
uniform vec4 colour;
void main() {
  float r = length(gl_PointCoord - 0.5);
  if (r > 0.5) discard;
  gl_FragColor = vec4(colour.rgb * (r > 0.38 ? 0.7 : 1.0), colour.a);
}`;

function compiled(gl, kind, source) {
  const shader = gl.createShader(kind);
  gl.shaderSource(shader, source.trim());
  gl.compileShader(shader);
  if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS) && !gl.isContextLost()) {
    throw new Error("A shader was refused: " + gl.getShaderInfoLog(shader));
  }
  return shader;
}

/** A linked program, and where its uniforms are. Attribute 0 is the position, 1 the normal. */
function makeProgram(gl, vertexSource, fragmentSource) {
  const program = gl.createProgram();
  gl.attachShader(program, compiled(gl, gl.VERTEX_SHADER, vertexSource));
  gl.attachShader(program, compiled(gl, gl.FRAGMENT_SHADER, fragmentSource));
  gl.bindAttribLocation(program, 0, "position");
  gl.bindAttribLocation(program, 1, "normal");
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost()) {
    throw new Error("The shaders do not fit: " + gl.getProgramInfoLog(program));
  }
  const at = {};
  const count = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS) || 0;
  for (let i = 0; i < count; ++i) {
    const { name } = gl.getActiveUniform(program, i);
    at[name] = gl.getUniformLocation(program, name);
  }
  return { program, at };
}
