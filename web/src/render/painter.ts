/**
 * The resources of one WebGL context, and the draw calls: programs, picture, mesh with weights, motions.
 *
 * A context loss loses all of them; `Renderer` then builds a new painter.
 *
 * Cost: a drag uploads 48 bytes per site and frame. A change of depth uploads the triangles in their new order. The GPU
 * blends the motions per vertex.
 */
import type { Box } from '../geometry/box';
import type { HeatMap } from '../geometry/heat';
import { type Blend, MOTION_STRIDE, type Places } from '../geometry/skin';
import type { View } from '../geometry/view';
import { type Buffers, createAttribute, createIndices, deleteBuffers, type Indices } from './buffers';
import { createDataTexture, type DataTexture } from './data_texture';
import { EdgeLayer } from './edges';
import { HeatLayer } from './heat';
import lineFragment from './line.frag.glsl?raw';
import {
  lineOpacity,
  meanEdge,
  meshEdges,
  staticMesh,
  unwarpedMesh,
  type WarpMesh,
  weightRows,
} from './mesh';
import { PictureTexture, setFilters, type TexturePatch, type TextureSource } from './picture';
import pictureFragment from './picture.frag.glsl?raw';
import { PixelLayer, type PixelMesh, showsPixels } from './pixel_layer';
import { PlaceBuffer } from './place_buffer';
import { drawWith, type Program, program } from './program';
import { RimLayer } from './rim';

/** The shade of the static background beside a selection: enough to distinguish it, but still clearly visible. */
const SHADE = 0.3;

/** Colour of the lines of a coarse mesh, premultiplied. It shows on light and dark pictures. */
const MESH_COLOUR = [0.0, 0.28, 0.5, 0.5];

interface LoadedMesh {
  readonly mesh: WarpMesh;
  readonly triangles: Buffers;
  readonly weights: DataTexture;
  readonly motions: DataTexture;
  edges: MeshLines | undefined;
  /** The content of the index buffer. */
  drawn: Uint32Array;
  readonly places: PlaceBuffer;
}

/** The edges of a mesh, and their mean length at rest, image pixels. */
interface MeshLines {
  readonly indices: Indices;
  readonly length: number;
}

export class Painter {
  readonly #gl: WebGL2RenderingContext;
  readonly #pictureProgram: Program;
  readonly #lineProgram: Program;
  #picture: PictureTexture | undefined;
  /** The picture with its fill, drawn whole behind the mesh instead of the static background. */
  #filled: PictureTexture | undefined;
  #loaded: LoadedMesh | undefined;
  /** The static background behind the mesh, if any. */
  #background: LoadedMesh | undefined;
  /** The soft rim of the mesh, if any. */
  #rim: RimLayer | undefined;
  /** The unwarped picture, for comparison. */
  #whole: LoadedMesh | undefined;
  /** Created at first use. */
  #heat: HeatLayer | undefined;
  /** Created at first use. */
  #pixels: PixelLayer | undefined;
  /** Created at the first crossing. */
  #edges: EdgeLayer | undefined;
  #crossed: Box | null = null;
  #posed = false;
  #blend: Blend = 'linear';

  /** @throws Error with the compiler's message if a shader does not compile. */
  constructor(gl: WebGL2RenderingContext) {
    this.#gl = gl;
    this.#pictureProgram = program(gl, pictureFragment);
    this.#lineProgram = program(gl, lineFragment);
  }

  setPicture(source: TextureSource): void {
    this.#picture?.dispose();
    const { width, height } = source;
    this.#picture = new PictureTexture(this.#gl, source);
    this.#unload(this.#whole);
    this.#whole = this.#load(unwarpedMesh(width, height));
  }

  /** Fills a part of the picture behind the mesh; null fills nothing. */
  setFill(source: TextureSource, patch: TexturePatch | null): void {
    this.#filled?.dispose();
    this.#filled = patch ? new PictureTexture(this.#gl, source, patch) : undefined;
  }

  get isLoading(): boolean {
    return this.#picture?.isLoading === true || this.#filled?.isLoading === true;
  }

  /** Uploads the next part of a large picture. Returns whether that was the last one. */
  load(): boolean {
    (this.#picture?.isLoading ? this.#picture : this.#filled)?.load();
    return !this.isLoading;
  }

  /** Frees picture and mesh. `draw` then clears the canvas only. */
  clear(): void {
    this.#picture?.dispose();
    this.#filled?.dispose();
    this.#filled = undefined;
    this.#unload(this.#whole);
    this.#unload(this.#loaded);
    this.#unload(this.#background);
    this.#rim?.dispose();
    this.#rim = undefined;
    this.#heat?.clear();
    this.#pixels?.dispose();
    this.#pixels = undefined;
    this.#edges?.dispose();
    this.#edges = undefined;
    [this.#picture, this.#whole, this.#loaded, this.#background] = [
      undefined,
      undefined,
      undefined,
      undefined,
    ];
  }

  /** Replaces the mesh, at rest until motions are set. */
  setMesh(mesh: WarpMesh): void {
    this.#unload(this.#loaded);
    this.#unload(this.#background);
    this.#rim?.dispose();
    this.#rim = RimLayer.of(this.#gl, mesh);
    this.#loaded = this.#load(mesh);
    const { backgroundPositions: positions, backgroundTriangles: triangles } = mesh;
    this.#background =
      positions && triangles?.length ? this.#load(staticMesh(positions, triangles)) : undefined;
    this.#heat?.clear();
    this.#posed = false;
  }

  #load(mesh: WarpMesh): LoadedMesh {
    const gl = this.#gl;
    const weights = createDataTexture(gl, 2, mesh.sites.length);
    const entries = new Float32Array(mesh.sites.length * 2);
    for (let entry = 0; entry < mesh.sites.length; entry++) {
      entries[entry * 2] = mesh.sites[entry] ?? 0;
      entries[entry * 2 + 1] = mesh.weights[entry] ?? 0;
    }
    weights.update(entries);
    const places = new PlaceBuffer(gl, createAttribute(gl, 2, mesh.positions), {
      a_row: createAttribute(gl, 2, weightRows(mesh.offsets)),
    });
    return {
      mesh,
      weights,
      motions: createDataTexture(gl, 4, (mesh.siteRest.length / 2) * (MOTION_STRIDE / 4)),
      triangles: { attributes: places.attributes, indices: createIndices(gl, mesh.triangles) },
      edges: undefined,
      drawn: mesh.triangles,
      places,
    };
  }

  /** Sets where the mesh lies before it is posed; null where it rests. */
  setPlaces(places: Places | null): void {
    this.#loaded?.places.set(places?.mesh ?? null);
    this.#rim?.places.set(places?.feather ?? null);
  }

  /**
   * Sets the motions, sites × 12; null draws the mesh at rest.
   *
   * @param triangles The mesh's triangles in the drawing order of the pose; null keeps the order of the mesh.
   * @param crossed The box around all crossings, whose edges are drawn; null for no edges.
   */
  setMotions(
    motions: Float32Array | null,
    blend: Blend,
    triangles: Uint32Array | null,
    crossed: Box | null,
  ): void {
    this.#posed = motions !== null;
    this.#crossed = crossed;
    this.#blend = blend;
    const loaded = this.#loaded;
    if (!motions || !loaded) return;
    loaded.motions.update(motions);
    this.#reorder(loaded, triangles ?? loaded.mesh.triangles);
  }

  /** Sets the heat map over the picture; null draws only the picture. */
  setHeat(heat: HeatMap | null): void {
    if (!heat) {
      this.#heat?.clear();
      return;
    }
    this.#heat ??= new HeatLayer(this.#gl);
    this.#heat.set(heat);
  }

  #reorder(loaded: LoadedMesh, triangles: Uint32Array): void {
    if (triangles === loaded.drawn) return;
    const gl = this.#gl;
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, loaded.triangles.indices.buffer);
    gl.bufferSubData(gl.ELEMENT_ARRAY_BUFFER, 0, triangles);
    loaded.drawn = triangles;
  }

  draw(view: View): void {
    const gl = this.#gl;
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, view.width, view.height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT);
    const loaded = view.compare ? this.#whole : this.#loaded;
    const picture = this.#picture;
    if (!loaded || !picture) return;

    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    setFilters(gl, picture.texture, view);
    const uniforms = {
      u_weights: loaded.weights.texture,
      u_motions: loaded.motions.texture,
      u_picture: picture.texture,
      u_picture_size: [picture.width, picture.height],
      u_canvas_size: [view.width, view.height],
      u_view: [view.scale, view.x, view.y],
      u_at_rest: view.compare === true || !this.#posed,
      u_rigid: this.#blend === 'rigid',
      u_shade: 0,
      u_moving: view.moving === true,
    };
    const filled = this.#filled?.isLoading ? undefined : this.#filled;
    const fills = filled !== undefined && this.#background !== undefined;
    const behind = view.compare ? undefined : fills ? this.#whole : this.#background;
    const atRest = { ...uniforms, u_at_rest: true, u_shade: view.overlays?.selection ? SHADE : 0 };
    if (fills) {
      setFilters(gl, filled.texture, view);
      atRest.u_picture = filled.texture;
    }
    const heat = view.compare || !this.#heat?.isSet ? undefined : this.#heat;
    if (showsPixels(view) && !heat) {
      const meshes: PixelMesh[] = behind ? [[behind.triangles, atRest]] : [];
      this.#pixels ??= new PixelLayer(gl);
      this.#pixels.draw([...meshes, [loaded.triangles, uniforms]], view);
    } else {
      if (behind) drawWith(gl, this.#pictureProgram, behind.triangles, atRest, gl.TRIANGLES);
      // As in exports, pixel art has no soft rims. At rest they show nothing. They lie beside the selection.
      if (this.#posed && !view.compare && !view.pixelated)
        this.#rim?.draw({ ...uniforms, u_shade: atRest.u_shade });
      if (heat) heat.draw(loaded.triangles, uniforms, view.pixelRatio ?? 1);
      else drawWith(gl, this.#pictureProgram, loaded.triangles, uniforms, gl.TRIANGLES);
      // As in exports, pixel art has no edges.
      if (this.#crossed && this.#posed && !view.compare && !view.pixelated) {
        this.#edges ??= new EdgeLayer(gl);
        this.#edges.draw(loaded.triangles, uniforms, picture, this.#crossed, view);
      }
    }
    if (view.overlays?.mesh && !view.compare) {
      loaded.edges ??= meshLines(gl, loaded);
      const opacity = lineOpacity((loaded.edges.length * view.scale) / (view.pixelRatio ?? 1));
      const u_colour = MESH_COLOUR.map((part) => part * opacity);
      const lines = { ...loaded.triangles, indices: loaded.edges.indices };
      drawWith(gl, this.#lineProgram, lines, { ...uniforms, u_colour }, gl.LINES);
    }
  }

  #unload(loaded: LoadedMesh | undefined): void {
    if (!loaded) return;
    loaded.weights.dispose();
    loaded.motions.dispose();
    loaded.places.dispose();
    deleteBuffers(this.#gl, loaded.triangles);
    this.#gl.deleteBuffer(loaded.edges?.indices.buffer ?? null);
  }
}

function meshLines(gl: WebGL2RenderingContext, { mesh }: LoadedMesh): MeshLines {
  const edges = meshEdges(mesh.triangles);
  return { indices: createIndices(gl, edges), length: meanEdge(edges, mesh.positions) };
}
