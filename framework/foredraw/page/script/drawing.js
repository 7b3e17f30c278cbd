// The graphics device: panes into the canvas, counts into targets that are read back.

import {
  BufferAttribute,
  BufferGeometry,
  Camera,
  Color,
  ColorManagement,
  LinearSRGBColorSpace,
  Mesh,
  NearestFilter,
  RGBAFormat,
  UnsignedByteType,
  WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import { heat_background } from './colours.js';
import { element } from './elements.js';
import { bytes_per_triangle, DrawnOrder } from './drawn_order.js';
import { make_materials } from './materials.js';
import { wire_functions } from './page_data.js';
import { make_wire_materials } from './wire_materials.js';

const kept_bytes = 256 * 2 ** 20; // of orders that are not drawn at the moment

const context_of = (canvas, antialias) => canvas.getContext('webgl2', { alpha: true, depth: true, antialias });

/** Whether a processor does the work of a graphics device. */
function is_software(context) {
  const name = context.getParameter(context.RENDERER);
  const details = /webkit/i.test(name) && context.getExtension('WEBGL_debug_renderer_info');
  return /swiftshader|llvmpipe|software|basic render/i.test(
    details ? context.getParameter(details.UNMASKED_RENDERER_WEBGL) : name,
  );
}

/**
 * A canvas that can be drawn on. Edges are smooth, but where a processor would take three times as long for it.
 * @returns {{canvas: HTMLCanvasElement, context: WebGL2RenderingContext}|null} null without WebGL 2
 */
export function make_canvas() {
  const make = () => element('canvas', { class: 'stage', 'aria-hidden': 'true' });
  const plain = make();
  const context = context_of(plain, false);
  if (context === null || is_software(context)) return context && { canvas: plain, context };
  context.getExtension('WEBGL_lose_context')?.loseContext();
  const smooth = make();
  return { canvas: smooth, context: context_of(smooth, true) };
}

function counting_target(width, height) {
  return new WebGLRenderTarget(width, height, {
    format: RGBAFormat,
    type: UnsignedByteType,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    generateMipmaps: false,
    depthBuffer: true,
    stencilBuffer: false,
    samples: 0,
  });
}

/** One triangle that covers everything. */
function full_screen(material) {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]), 3));
  const mesh = new Mesh(geometry, material);
  mesh.frustumCulled = false;
  return mesh;
}

export class Drawing {
  constructor(canvas, context) {
    ColorManagement.enabled = false;
    this.renderer = new WebGLRenderer({ canvas, context, alpha: true });
    this.renderer.outputColorSpace = LinearSRGBColorSpace;
    this.renderer.autoClear = false;
    this.renderer.sortObjects = false; // the sequence of drawing is what all this is about
    this.materials = make_materials();
    this.wire_materials = null;
    this.heat_pass = full_screen(this.materials.heat_map);
    this.counts = counting_target(1, 1);
    this.orders = new Map(); // by what the state tells of the order, those drawn last at the end
    this.subject = null;
  }

  set_subject(subject) {
    for (const order of this.orders.values()) order.dispose();
    this.orders.clear();
    this.subject = subject;
  }

  set_size(width, height, pixel_ratio) {
    this.renderer.setPixelRatio(pixel_ratio);
    this.renderer.setSize(width, height, false);
  }

  /**
   * A state of the subject, or one of its levels, in its order k, ready to be drawn in this pose and on this way to the
   * next coarser level; made on the first ask.
   */
  order(state, k, pose, way) {
    const key = state.orders[k];
    const order = this.orders.get(key) ?? new DrawnOrder(state, k, this.subject.frame);
    this.orders.delete(key);
    this.orders.set(key, order);
    let triangles = [...this.orders.values()].reduce((sum, one) => sum + one.state.triangles, 0);
    for (const [old_key, old] of this.orders) {
      if (this.orders.size <= 2 || bytes_per_triangle * triangles <= kept_bytes) break;
      triangles -= old.state.triangles;
      old.dispose();
      this.orders.delete(old_key);
    }
    order.set_pose(pose, way);
    return order;
  }

  clear() {
    this.renderer.setRenderTarget(null);
    this.renderer.setScissorTest(false);
    this.renderer.setClearColor(0, 0);
    this.renderer.clear();
  }

  /**
   * Draws into a rectangle of the canvas, in CSS pixels from its lower left corner.
   * @param {{x, y, width, height}} place
   * @param {'shaded'|'heat'|'order'|'clusters'|'deviation'} mode
   * @param {number[]} background  of the pane, [r, g, b]
   */
  draw_pane(place, mode, order, camera, drawn, background) {
    order.set_drawn(drawn);
    if (mode === 'heat') this.count_pane(place, order, camera);
    this.renderer.setRenderTarget(null);
    this.renderer.setViewport(place.x, place.y, place.width, place.height);
    this.renderer.setScissor(place.x, place.y, place.width, place.height);
    this.renderer.setScissorTest(true);
    this.renderer.setClearColor(new Color(...(mode === 'heat' ? heat_background : background).map((c) => c / 255)), 1);
    this.renderer.clear();
    if (mode === 'heat') {
      this.renderer.render(this.heat_pass, new Camera());
    } else if (mode === 'deviation') {
      // Between small triangles of different sizes a pixel may be left open: the triangles themselves lie behind it.
      order.set_materials(this.materials.behind_deviation);
      this.renderer.render(order.scene, camera);
      order.set_materials(this.materials.deviation);
      this.renderer.render(order.deviation.scene, camera);
    } else if (mode === 'shaded' && order.state.has_wires) {
      this.wire_materials ??= make_wire_materials(wire_functions(), this.samples());
      const render = () => this.renderer.render(order.scene, camera);
      order.wire_parts().draw(render, this.wire_materials, this.materials.solid);
    } else {
      if (mode !== 'shaded') order.set_tints(mode);
      order.set_materials(mode === 'shaded' ? this.materials.solid : this.materials.tinted);
      this.renderer.render(order.scene, camera);
    }
    this.renderer.setScissorTest(false);
  }

  /** Of a pixel of the canvas. */
  samples() {
    const gl = this.renderer.getContext();
    return Math.max(1, gl.getParameter(gl.SAMPLES));
  }

  /** Up to where the first colour of distances goes. */
  set_first_distance(distance) {
    this.materials.first_distance.value = distance;
  }

  count_pane({ x, y, width, height }, order, camera) {
    const ratio = this.renderer.getPixelRatio();
    const [wide, high] = [Math.round(width * ratio), Math.round(height * ratio)];
    if (this.counts.width !== wide || this.counts.height !== high) this.counts.setSize(wide, high);
    this.count_into(this.counts, order, camera);
    const { uniforms } = this.materials.heat_map;
    uniforms.counts.value = this.counts.texture;
    uniforms.corner.value.set(Math.round(x * ratio), Math.round(y * ratio));
  }

  /** Each fragment that passes adds 1/255 to its pixel. */
  count_into(target, order, camera) {
    order.set_materials(this.materials.counting);
    this.renderer.setRenderTarget(target);
    this.renderer.setClearColor(0, 0);
    this.renderer.clear();
    this.renderer.render(order.scene, camera);
    this.renderer.setRenderTarget(null);
  }

  /**
   * How often each pixel is shaded, in pictures of size x size pixels beside each other in a row.
   * @param {{order: () => DrawnOrder, camera: () => Camera}[]} pictures
   * @returns {Promise<Uint8Array[]>} one for each picture, row 0 at the bottom
   */
  async counted(pictures, size, drawn) {
    const target = counting_target(size * pictures.length, size);
    target.scissorTest = true;
    pictures.forEach((picture, i) => {
      const order = picture.order();
      order.set_drawn(drawn);
      target.viewport.set(i * size, 0, size, size);
      target.scissor.set(i * size, 0, size, size);
      this.count_into(target, order, picture.camera());
    });
    const row = 4 * size * pictures.length;
    const pixels = new Uint8Array(row * size);
    await this.renderer.readRenderTargetPixelsAsync(target, 0, 0, size * pictures.length, size, pixels);
    target.dispose();
    return pictures.map((_, picture) => {
      const counts = new Uint8Array(size * size);
      for (let y = 0; y < size; ++y) {
        for (let x = 0; x < size; ++x) counts[y * size + x] = pixels[y * row + 4 * (picture * size + x)];
      }
      return counts;
    });
  }
  /** The canvas as it was drawn in this very task: {width, height, data}. */
  read({ x, y, width, height }) {
    const gl = this.renderer.getContext();
    const [left, low, wide, high] = [x, y, width, height].map((edge) =>
      Math.round(edge * this.renderer.getPixelRatio()),
    );
    const data = new Uint8Array(4 * wide * high);
    gl.readPixels(left, low, wide, high, gl.RGBA, gl.UNSIGNED_BYTE, data);
    return { width: wide, height: high, data };
  }
}
