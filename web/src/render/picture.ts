/**
 * The picture as a texture with mipmaps.
 *
 * The texture is premultiplied: filtering and blending then ignore the colours of transparent pixels. Anisotropic
 * filtering is off, so that all GPUs give the same result.
 */
import type { View } from '../geometry/view';

/** Above this many device pixels per image pixel, image pixels are drawn as squares. */
const CRISP_ABOVE = 4;

/** So many pixels upload within a frame of a slow machine: 8 MB. */
const PART = 2e6;

/** Premultiplied copies of a picture for the screen. */
export interface TextureSource {
  /** Size of the picture. The copies may be smaller. */
  readonly width: number;
  readonly height: number;
  readonly bitmap: ImageBitmap;
  /** Shown while a large bitmap is uploaded in parts; null if that takes one step. */
  readonly preview: ImageBitmap | null;
}

/** A part of a picture with other pixels. */
export interface TexturePatch {
  /** Of its upper left corner, image pixels. */
  readonly left: number;
  readonly top: number;
  /** Premultiplied, at the size of the picture itself. */
  readonly bitmap: ImageBitmap;
}

/** A texture of a picture, which a large picture fills part by part. */
export class PictureTexture {
  readonly width: number;
  readonly height: number;
  readonly #gl: WebGL2RenderingContext;
  readonly #bitmap: ImageBitmap;
  readonly #patch: TexturePatch | null;
  readonly #full: WebGLTexture;
  #preview: WebGLTexture | null = null;
  /** Rows that are uploaded. */
  #rows = 0;

  /** @param patch Replaces a part of the picture. It is drawn once all of it is uploaded. */
  constructor(
    gl: WebGL2RenderingContext,
    { width, height, bitmap, preview }: TextureSource,
    patch: TexturePatch | null = null,
  ) {
    this.#gl = gl;
    this.width = width;
    this.height = height;
    this.#bitmap = bitmap;
    this.#patch = patch;
    this.#full = storage(gl, bitmap);
    if (preview && patch) return;
    if (preview) {
      this.#preview = storage(gl, preview);
      uploadRows(gl, this.#preview, preview, 0, preview.height);
    } else this.#upload(bitmap.height);
  }

  /** The texture to draw: the preview until the last part is uploaded. */
  get texture(): WebGLTexture {
    return this.#preview ?? this.#full;
  }

  get isLoading(): boolean {
    return this.#rows < this.#bitmap.height;
  }

  /** Uploads the next part. */
  load(): void {
    if (this.isLoading) this.#upload(Math.max(1, Math.floor(PART / this.#bitmap.width)));
  }

  dispose(): void {
    this.#gl.deleteTexture(this.#preview);
    this.#gl.deleteTexture(this.#full);
  }

  #uploadPatch(patch: TexturePatch): void {
    const gl = this.#gl;
    const scale = this.#bitmap.width / this.width;
    gl.bindTexture(gl.TEXTURE_2D, this.#full);
    if (scale === 1) {
      gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
      gl.texSubImage2D(gl.TEXTURE_2D, 0, patch.left, patch.top, gl.RGBA, gl.UNSIGNED_BYTE, patch.bitmap);
    } else {
      const { x, y, canvas } = scaledPatch(patch, this.#bitmap, scale);
      gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, true);
      gl.texSubImage2D(gl.TEXTURE_2D, 0, x, y, gl.RGBA, gl.UNSIGNED_BYTE, canvas);
      gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
    }
    gl.generateMipmap(gl.TEXTURE_2D);
  }

  #upload(most: number): void {
    const rows = Math.min(most, this.#bitmap.height - this.#rows);
    uploadRows(this.#gl, this.#full, this.#bitmap, this.#rows, rows);
    this.#rows += rows;
    if (this.isLoading) return;
    if (this.#patch) this.#uploadPatch(this.#patch);
    this.#gl.deleteTexture(this.#preview);
    this.#preview = null;
  }
}

/** The part of a copy of a picture that a patch covers, with the patch at the scale of the copy. */
function scaledPatch({ left, top, bitmap }: TexturePatch, copy: ImageBitmap, scale: number) {
  const x = Math.floor(left * scale);
  const y = Math.floor(top * scale);
  const width = Math.min(copy.width, Math.ceil((left + bitmap.width) * scale)) - x;
  const height = Math.min(copy.height, Math.ceil((top + bitmap.height) * scale)) - y;
  const canvas = Object.assign(document.createElement('canvas'), { width, height });
  const pen = canvas.getContext('2d');
  pen?.drawImage(copy, -x, -y);
  pen?.drawImage(bitmap, left * scale - x, top * scale - y, bitmap.width * scale, bitmap.height * scale);
  return { x, y, canvas };
}

/**
 * Sets the filters for a view. Enlarged pixels are squares at high zoom and for pixel art, else linear. A picture that
 * moves is read from one mip level, and at rest from two.
 */
export function setFilters(
  gl: WebGL2RenderingContext,
  texture: WebGLTexture,
  { scale, pixelated = false, moving = false }: View,
): void {
  gl.bindTexture(gl.TEXTURE_2D, texture);
  const crisp = pixelated || scale > CRISP_ABOVE;
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, crisp ? gl.NEAREST : gl.LINEAR);
  const minified = moving ? gl.LINEAR_MIPMAP_NEAREST : gl.LINEAR_MIPMAP_LINEAR;
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, minified);
}

/** Returns an empty texture with all mip levels. */
function storage(gl: WebGL2RenderingContext, { width, height }: ImageBitmap): WebGLTexture {
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texStorage2D(gl.TEXTURE_2D, 1 + Math.floor(Math.log2(Math.max(width, height))), gl.RGBA8, width, height);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
  return texture;
}

/** Uploads rows of a premultiplied bitmap, and makes the mip levels after the last one. */
function uploadRows(
  gl: WebGL2RenderingContext,
  texture: WebGLTexture,
  bitmap: ImageBitmap,
  from: number,
  rows: number,
): void {
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
  gl.pixelStorei(gl.UNPACK_SKIP_ROWS, from);
  gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, from, bitmap.width, rows, gl.RGBA, gl.UNSIGNED_BYTE, bitmap);
  gl.pixelStorei(gl.UNPACK_SKIP_ROWS, 0);
  if (from + rows === bitmap.height) gl.generateMipmap(gl.TEXTURE_2D);
}
