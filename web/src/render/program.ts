/** Compiles shader programs that draw the posed mesh, and draws with them. */
import * as twgl from 'twgl.js';
import warpVertex from './warp.vert.glsl?raw';

const compiled = new WeakMap<WebGL2RenderingContext, Map<string, twgl.ProgramInfo>>();

/**
 * Returns the program with a fragment shader. Each program is compiled once per context.
 *
 * @param define A macro that the vertex shader tests with `#ifdef`.
 * @throws Error with the compiler's message if a shader does not compile.
 */
export function program(gl: WebGL2RenderingContext, fragment: string, define = ''): twgl.ProgramInfo {
  const programs = compiled.get(gl) ?? new Map<string, twgl.ProgramInfo>();
  compiled.set(gl, programs);
  const known = programs.get(fragment);
  // A program from before a context loss is invalid.
  if (known && gl.isProgram(known.program)) return known;
  const info = compile(gl, fragment, define);
  programs.set(fragment, info);
  return info;
}

function compile(gl: WebGL2RenderingContext, fragment: string, define: string): twgl.ProgramInfo {
  let reason = 'unknown';
  // `#version` must stay the first line.
  const vertex = define ? warpVertex.replace('\n', `\n#define ${define}\n`) : warpVertex;
  const info: twgl.ProgramInfo | null = twgl.createProgramInfo(gl, [vertex, fragment], (message) => {
    reason = message;
  });
  if (!info) throw new Error(`A shader does not compile: ${reason}`);
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
