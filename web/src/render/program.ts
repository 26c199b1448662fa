/** Compiles shader programs that draw the posed mesh or the whole screen, and draws with them. */
import { type Buffers, bindBuffers } from './buffers';
import { type SetUniforms, type Uniforms, uniformsOf } from './uniforms';
import warpVertex from './warp.vert.glsl?raw';

export interface Program {
  readonly program: WebGLProgram;
  /** Of the attributes that its shaders use. Vertices without a buffer do not need one. */
  readonly locations: ReadonlyMap<string, number>;
  readonly setUniforms: SetUniforms;
}

const compiled = new WeakMap<WebGL2RenderingContext, Map<string, Program>>();

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
export const program = (gl: WebGL2RenderingContext, fragment: string, define = ''): Program =>
  compiledOnce(gl, defining(define, warpVertex), defining(define, fragment));

/** `#version` must stay the first line. */
const defining = (macro: string, shader: string): string =>
  macro ? shader.replace('\n', `\n#define ${macro}\n`) : shader;

/** Returns the program that draws over the whole screen. @throws the errors of {@link program}. */
export const screenProgram = (gl: WebGL2RenderingContext, fragment: string): Program =>
  compiledOnce(gl, SCREEN, fragment);

/** Each fragment shader belongs to one vertex shader. */
function compiledOnce(gl: WebGL2RenderingContext, vertex: string, fragment: string): Program {
  const programs = compiled.get(gl) ?? new Map<string, Program>();
  compiled.set(gl, programs);
  const known = programs.get(fragment);
  // A program from before a context loss is invalid.
  if (known && gl.isProgram(known.program)) return known;
  const program = linked(gl, vertex, fragment);
  const made = { program, locations: locationsOf(gl, program), setUniforms: uniformsOf(gl, program) };
  programs.set(fragment, made);
  return made;
}

/** @throws the errors of {@link program}. */
function linked(gl: WebGL2RenderingContext, vertex: string, fragment: string): WebGLProgram {
  const program = gl.createProgram();
  const shaders = [gl.createShader(gl.VERTEX_SHADER), gl.createShader(gl.FRAGMENT_SHADER)] as const;
  for (const [index, source] of [vertex, fragment].entries()) {
    const shader = shaders[index] as WebGLShader;
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) {
    const logs = [
      ...shaders.map((shader) => shader && gl.getShaderInfoLog(shader)),
      gl.getProgramInfoLog(program),
    ];
    throw new Error(`A shader does not compile: ${logs.filter(Boolean).join('\n') || 'unknown'}`);
  }
  // They live on with their program.
  for (const shader of shaders) gl.deleteShader(shader);
  return program;
}

function locationsOf(gl: WebGL2RenderingContext, program: WebGLProgram): ReadonlyMap<string, number> {
  const count: number = gl.getProgramParameter(program, gl.ACTIVE_ATTRIBUTES);
  const names = Array.from({ length: count }, (_, at) => gl.getActiveAttrib(program, at)?.name ?? '');
  return new Map(names.map((name) => [name, gl.getAttribLocation(program, name)]));
}

export function drawWith(
  gl: WebGL2RenderingContext,
  { program, locations, setUniforms }: Program,
  buffers: Buffers,
  uniforms: Uniforms,
  primitive: number,
): void {
  gl.useProgram(program);
  bindBuffers(gl, locations, buffers);
  setUniforms(uniforms);
  gl.drawElements(primitive, buffers.indices.count, gl.UNSIGNED_INT, 0);
}

/** Draws over the whole screen with a {@link screenProgram}. */
export function drawScreen(
  gl: WebGL2RenderingContext,
  { program, setUniforms }: Program,
  uniforms: Uniforms,
): void {
  gl.useProgram(program);
  setUniforms(uniforms);
  gl.drawArrays(gl.TRIANGLES, 0, 3);
}
