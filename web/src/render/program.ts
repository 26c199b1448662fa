/** Compiles shader programs that draw the posed mesh or the whole screen, and draws with them. */
import * as twgl from 'twgl.js';
import warpVertex from './warp.vert.glsl?raw';

const compiled = new WeakMap<WebGL2RenderingContext, Map<string, twgl.ProgramInfo>>();

/** One triangle that covers the screen. */
const SCREEN = `#version 300 es
void main() {
  gl_Position = vec4(vec2(gl_VertexID % 2, gl_VertexID / 2) * 4.0 - 1.0, 0.0, 1.0);
}`;

/**
 * Returns the program that draws the posed mesh with a fragment shader. Each program is compiled once per context.
 *
 * @param define A macro that the shaders test with `#ifdef`.
 * @throws Error with the compiler's message if a shader does not compile.
 */
export const program = (gl: WebGL2RenderingContext, fragment: string, define = ''): twgl.ProgramInfo =>
  compiledOnce(gl, defining(define, warpVertex), defining(define, fragment));

/** `#version` must stay the first line. */
const defining = (macro: string, shader: string): string =>
  macro ? shader.replace('\n', `\n#define ${macro}\n`) : shader;

/** Returns the program that draws over the whole screen. @throws as {@link program}. */
export const screenProgram = (gl: WebGL2RenderingContext, fragment: string): twgl.ProgramInfo =>
  compiledOnce(gl, SCREEN, fragment);

/** Each fragment shader belongs to one vertex shader. */
function compiledOnce(gl: WebGL2RenderingContext, vertex: string, fragment: string): twgl.ProgramInfo {
  const programs = compiled.get(gl) ?? new Map<string, twgl.ProgramInfo>();
  compiled.set(gl, programs);
  const known = programs.get(fragment);
  // A program from before a context loss is invalid.
  if (known && gl.isProgram(known.program)) return known;
  let reason = 'unknown';
  const info: twgl.ProgramInfo | null = twgl.createProgramInfo(gl, [vertex, fragment], (message) => {
    reason = message;
  });
  if (!info) throw new Error(`A shader does not compile: ${reason}`);
  programs.set(fragment, info);
  return info;
}

export function drawWith(
  gl: WebGL2RenderingContext,
  info: twgl.ProgramInfo,
  buffers: twgl.BufferInfo,
  uniforms: Record<string, unknown>,
  primitive: number,
): void {
  gl.useProgram(info.program);
  twgl.setBuffersAndAttributes(gl, info, buffers);
  twgl.setUniforms(info, uniforms);
  twgl.drawBufferInfo(gl, buffers, primitive);
}

/** Draws over the whole screen with a {@link screenProgram}. */
export function drawScreen(
  gl: WebGL2RenderingContext,
  info: twgl.ProgramInfo,
  uniforms: Record<string, unknown>,
): void {
  gl.useProgram(info.program);
  twgl.setUniforms(info, uniforms);
  gl.drawArrays(gl.TRIANGLES, 0, 3);
}
