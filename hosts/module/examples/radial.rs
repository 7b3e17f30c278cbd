//! A module: an orderer of triangles, as radial.c is one.
//! rustc --edition 2021 -O --crate-type cdylib -o radial_rs.so radial.rs
use std::os::raw::{c_char, c_int, c_void};
use std::ptr::null;

// foredraw/c/plugin.h and module.h, as far as an orderer needs them.
#[repr(C)]
pub struct Draw {
    size: u32,
    vertex_count: u32,
    triangle_count: u64,
    name: *const c_char,
    indices: *const u32,
    positions: *const f32,
    stream_count: u32,
    streams: *const c_void,
    cluster_count: u32,
    cluster_offsets: *const u32,
}
#[repr(C)]
pub struct Value {
    integer: i64,
    number: f64,
    text: *const c_char,
}
#[repr(C)]
pub struct OptionRow {
    name: *const c_char,
    doc: *const c_char,
    unit: *const c_char,
    kind: u32,
    choice_count: u32,
    choices: *const *const c_char,
    initial: Value,
    least: f64,
    most: f64,
}
#[repr(C)]
pub struct Answer {
    values: *mut u32,
    count: u64,
}
type Run = extern "C" fn(*mut c_void, *const Draw, *const Value, *mut Answer, *const c_void) -> c_int;
#[repr(C)]
pub struct Plugin {
    size: u32,
    kind: u32,
    name: *const c_char,
    summary: *const c_char,
    reference: *const c_char,
    needs: *const c_char,
    provides: *const c_char,
    breaks: *const c_char,
    options: *const OptionRow,
    metrics: *const c_void,
    option_count: u32,
    metric_count: u32,
    runs_on_many_threads: u32,
    user: *mut c_void,
    run: Run,
}
#[repr(C)]
pub struct Module {
    size: u32,
    major: u32,
    minor: u32,
    plugin_count: u32,
    vendor: *const c_char,
    version: *const c_char,
    plugins: *const &'static Plugin,
}
unsafe impl Sync for OptionRow {}
unsafe impl Sync for Plugin {}
unsafe impl Sync for Module {}

const ORDERER: u32 = 1;
const NUMBER: u32 = 3;
const fn text(with_zero: &'static [u8]) -> *const c_char {
    with_zero.as_ptr() as *const c_char
}

/// Triangles far from the mesh's origin first.
fn radial(positions: &[f32], indices: &[u32], height: f64, order: &mut [u32]) {
    let distance = |triangle: u32| {
        let corners = &indices[3 * triangle as usize..][..3];
        let sum = corners.iter().fold(0.0, |sum, &vertex| {
            let p = &positions[3 * vertex as usize..][..3];
            let (x, y, z) = (p[0] as f64, height * p[1] as f64, p[2] as f64);
            sum + (x * x + y * y + z * z)
        });
        if sum >= 0.0 { sum } else { -1.0 } // where a position is no number
    };
    let distances: Vec<f64> = (0..order.len() as u32).map(distance).collect();
    order.iter_mut().enumerate().for_each(|(new, old)| *old = new as u32);
    order.sort_by(|&a, &b| distances[b as usize].total_cmp(&distances[a as usize])); // equal ones keep their sequence
}

/// A panic must not cross the border: it becomes FOREDRAW_FAILED.
extern "C" fn run(_user: *mut c_void, draw: *const Draw, options: *const Value, answer: *mut Answer, _host: *const c_void) -> c_int {
    use std::slice::{from_raw_parts, from_raw_parts_mut};
    let ordered = std::panic::catch_unwind(|| unsafe {
        let (draw, answer) = (&*draw, &mut *answer);
        if draw.triangle_count > 0 {
            let positions = from_raw_parts(draw.positions, 3 * draw.vertex_count as usize);
            let indices = from_raw_parts(draw.indices, 3 * draw.triangle_count as usize);
            radial(positions, indices, (*options).number, from_raw_parts_mut(answer.values, answer.count as usize));
        }
    });
    if ordered.is_ok() { 0 } else { 2 }
}

static OPTIONS: [OptionRow; 1] = [OptionRow {
    name: text(b"height\0"),
    doc: text(b"How much height counts\0"),
    unit: null(),
    kind: NUMBER,
    choice_count: 0,
    choices: null(),
    initial: Value { integer: 0, number: 1.0, text: null() },
    least: 0.0,
    most: 10.0,
}];
static PLUGIN: Plugin = Plugin {
    size: std::mem::size_of::<Plugin>() as u32,
    kind: ORDERER,
    name: text(b"acme-radial\0"),
    summary: text(b"Draws triangles far from the origin first\0"),
    reference: text(b"own\0"),
    needs: null(),
    provides: text(b"overdraw-ordered\0"),
    breaks: text(b"cache-ordered fetch-ordered clustered\0"),
    options: OPTIONS.as_ptr(),
    metrics: null(),
    option_count: 1,
    metric_count: 0,
    runs_on_many_threads: 1,
    user: std::ptr::null_mut(),
    run,
};
static PLUGINS: [&Plugin; 1] = [&PLUGIN];
static MODULE: Module = Module {
    size: std::mem::size_of::<Module>() as u32,
    major: 1,
    minor: 0,
    plugin_count: 1,
    vendor: text(b"acme\0"),
    version: text(b"1.0.0\0"),
    plugins: PLUGINS.as_ptr(),
};

#[no_mangle]
pub extern "C" fn foredraw_module_v1() -> *const Module {
    &MODULE
}
