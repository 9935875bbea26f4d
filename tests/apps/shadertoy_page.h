// A web page that plays a pair of Shadertoy shaders in WebGL2, written apart from the runner and by the same
// contract: what it says is a second opinion.
#pragma once

namespace program_test {

/// Goes behind a script that sets `tabs` (common, buffer_a, image), `frames`, `width` and `height`. Leaves
/// JSON in the element `out`: error, or count, dimensions, flocks, bits (of the floats of each boid's state)
/// and blocks (sums of red, green and blue over squares of 16 pixels, from the top left).
inline constexpr const char* shadertoy_page = R"page(
const head = `#version 300 es
precision highp float; precision highp int; precision highp sampler2D;
uniform vec3 iResolution; uniform float iTime, iTimeDelta, iFrameRate; uniform int iFrame;
uniform vec4 iMouse, iDate; uniform vec3 iChannelResolution[4]; uniform float iChannelTime[4];
uniform sampler2D iChannel0, iChannel1, iChannel2, iChannel3;
`;
const canvas = document.createElement('canvas');
const gl = canvas.getContext('webgl2', { antialias: false });

function program_of(name, text) {
  const program = gl.createProgram();
  const corner = `#version 300 es
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }`;
  for (const [kind, source] of [[gl.VERTEX_SHADER, corner], [gl.FRAGMENT_SHADER, text]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw name + ': ' + gl.getShaderInfoLog(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw name + ': ' + gl.getProgramInfoLog(program);
  return program;
}

function pass(name) {
  const alpha = name == 'image' ? '1.0' : 'c.a';
  return program_of(name, head + tabs.common + '\n' + tabs[name] +
    `\nout vec4 page_out; void main() { vec4 c = vec4(0, 0, 0, 1); mainImage(c, gl_FragCoord.xy); page_out = vec4(c.rgb, ${alpha}); }`);
}

function texture(stored, w, h, order, type, texels, filter, wrap) {
  const name = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, name);
  gl.texImage2D(gl.TEXTURE_2D, 0, stored, w, h, 0, order, type, texels);
  for (const use of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, use, filter);
  for (const axis of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, axis, wrap);
  return { name, w, h };
}

function target(stored, w, h, order, type) {
  const made = texture(stored, w, h, order, type, null, gl.NEAREST, gl.CLAMP_TO_EDGE);
  made.framebuffer = gl.createFramebuffer();
  gl.bindFramebuffer(gl.FRAMEBUFFER, made.framebuffer);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, made.name, 0);
  if (gl.checkFramebufferStatus(gl.FRAMEBUFFER) != gl.FRAMEBUFFER_COMPLETE) throw 'no such target';
  return made;
}

// The noise as the contract has it.
function noise() {
  const out = new Uint8Array(256 * 256 * 4);
  for (let key = 0; key < out.length; ++key) {
    const v = (Math.imul(key, 747796405) + 2891336453) >>> 0;
    let w = Math.imul((v >>> ((v >>> 28) + 4)) ^ v, 277803737) >>> 0;
    w = ((w >>> 22) ^ w) >>> 0;
    out[key] = w >>> 24;
  }
  return texture(gl.RGBA8, 256, 256, gl.RGBA, gl.UNSIGNED_BYTE, out, gl.LINEAR, gl.REPEAT);
}

function draw(program, to, channels, frame) {
  const at = name => gl.getUniformLocation(program, name);
  gl.bindFramebuffer(gl.FRAMEBUFFER, to.framebuffer);
  gl.viewport(0, 0, to.w, to.h);
  gl.useProgram(program);
  gl.uniform3f(at('iResolution'), width, height, 1);
  gl.uniform1f(at('iTime'), frame / 60);
  gl.uniform1f(at('iTimeDelta'), 1 / 60);
  gl.uniform1f(at('iFrameRate'), 60);
  gl.uniform1i(at('iFrame'), frame);
  for (let i = 0; i < 4; ++i) {
    gl.activeTexture(gl.TEXTURE0 + i);
    gl.bindTexture(gl.TEXTURE_2D, channels[i] ? channels[i].name : null);
    gl.uniform1i(at('iChannel' + i), i);
    if (channels[i]) gl.uniform3f(at(`iChannelResolution[${i}]`), channels[i].w, channels[i].h, 1);
  }
  gl.drawArrays(gl.TRIANGLES, 0, 3);
}

function asked(probe, w, h) {
  const to = target(gl.RGBA32I, w, h, gl.RGBA_INTEGER, gl.INT);
  draw(probe, to, [], 0);
  const out = new Int32Array(4 * w * h);
  gl.readPixels(0, 0, w, h, gl.RGBA_INTEGER, gl.INT, out);
  return out;
}

function blocks_of(picture) {
  const across = Math.ceil(width / 16), sums = new Array(3 * across * Math.ceil(height / 16)).fill(0);
  for (let y = 0; y < height; ++y) for (let x = 0; x < width; ++x) for (let c = 0; c < 3; ++c)
    sums[3 * (Math.floor((height - 1 - y) / 16) * across + Math.floor(x / 16)) + c] += picture[4 * (y * width + x) + c];
  return sums;
}

function play() {
  if (!gl) throw 'no WebGL2';
  if (!gl.getExtension('EXT_color_buffer_float')) throw 'no EXT_color_buffer_float';
  const probe = program_of('probe', head + tabs.common + `
out ivec4 page_out; void main() { int i = int(gl_FragCoord.x) + 64 * int(gl_FragCoord.y);
page_out = i == 0 ? ivec4(COUNT, DIMENSIONS, 0, 0) : ivec4(flock_of(i - 1), texel_of(i - 1), 0); }`);
  const buffer_a = pass('buffer_a'), image = pass('image'), random = noise();
  let now = target(gl.RGBA32F, width, height, gl.RGBA, gl.FLOAT), before = target(gl.RGBA32F, width, height, gl.RGBA, gl.FLOAT);
  for (let frame = 0; frame <= frames; ++frame) {
    [now, before] = [before, now];
    draw(buffer_a, now, [before, random], frame);
  }
  const texels = new Float32Array(4 * width * height), bits = new Int32Array(texels.buffer);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, texels);

  const shown = target(gl.RGBA8, width, height, gl.RGBA, gl.UNSIGNED_BYTE);
  draw(image, shown, [now], frames);
  const picture = new Uint8Array(4 * width * height);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, picture);

  const [count, dimensions] = asked(probe, 1, 1);
  const about = asked(probe, 64, Math.floor(count / 64) + 1);
  const out = { count, dimensions, flocks: [], bits: [], blocks: blocks_of(picture) };
  for (let i = 1; i <= count; ++i) {
    out.flocks.push(about[4 * i]);
    const first = 4 * (about[4 * i + 2] * width + about[4 * i + 1]);
    for (const axis of dimensions == 2 ? [0, 1, 2, 3] : [0, 1, 2, 4, 5, 6]) out.bits.push(bits[first + axis]);
  }
  if (gl.getError() != gl.NO_ERROR || gl.isContextLost()) throw 'WebGL failed';
  return out;
}

let said;
try { said = play(); } catch (error) { said = { error: String(error) }; }
document.getElementById('out').textContent = JSON.stringify(said);
)page";

}  // namespace program_test
