/** The uniforms of a program, set by their names. */

export type UniformValue = number | boolean | readonly number[] | WebGLTexture;

/** By their names in shaders. Those that a shader does not use are ignored. */
export type Uniforms = Readonly<Record<string, UniformValue>>;

/** Sets the uniforms of a program that is in use. Those without a value keep their own. */
export type SetUniforms = (uniforms: Uniforms) => void;

export function uniformsOf(gl: WebGL2RenderingContext, program: WebGLProgram): SetUniforms {
  const count: number = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS);
  const setters = new Map<string, (value: UniformValue) => void>();
  let textures = 0;
  for (let at = 0; at < count; at++) {
    const { name, type } = gl.getActiveUniform(program, at) as WebGLActiveInfo;
    const location = gl.getUniformLocation(program, name);
    const isTexture = type === gl.SAMPLER_2D || type === gl.UNSIGNED_INT_SAMPLER_2D;
    const unit = isTexture ? textures++ : 0;
    // Arrays are named by their first item.
    setters.set(name.replace('[0]', ''), setter(gl, type, location, unit));
  }
  return (uniforms) => {
    for (const [name, set] of setters) {
      const value = uniforms[name];
      if (value !== undefined) set(value);
    }
  };
}

/** @param unit of a texture. */
function setter(
  gl: WebGL2RenderingContext,
  type: number,
  location: WebGLUniformLocation | null,
  unit: number,
): (value: UniformValue) => void {
  switch (type) {
    case gl.FLOAT:
      return (value) => gl.uniform1f(location, Number(value));
    case gl.FLOAT_VEC2:
      return (value) => gl.uniform2fv(location, value as number[]);
    case gl.FLOAT_VEC3:
      return (value) => gl.uniform3fv(location, value as number[]);
    case gl.FLOAT_VEC4:
      return (value) => gl.uniform4fv(location, value as number[]);
    case gl.INT:
    case gl.BOOL:
      return (value) => gl.uniform1i(location, Number(value));
    case gl.SAMPLER_2D:
    case gl.UNSIGNED_INT_SAMPLER_2D:
      return (value) => {
        gl.activeTexture(gl.TEXTURE0 + unit);
        gl.bindTexture(gl.TEXTURE_2D, value as WebGLTexture);
        gl.uniform1i(location, unit);
      };
    default:
      throw new Error(`No shader here has uniforms of the type ${type}`);
  }
}
