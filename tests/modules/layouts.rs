
// Behind radial.rs: prints what rustc makes of its structs, as tests/c/layouts.c prints C's. A struct that has more
// members in C ends where these begin.
fn size_of_target<T>(_: *const T) -> usize {
    std::mem::size_of::<T>()
}

macro_rules! layout {
    ($Struct:ident as $name:literal, end $end:literal: $($member:ident $(as $in_c:literal)?),*) => {
        let _every_member_is_named = |whole: $Struct| { let $Struct { $($member: _),* } = whole; };
        let place = std::mem::MaybeUninit::<$Struct>::uninit();
        let start = place.as_ptr();
        println!(concat!($name, $end, " {}"), std::mem::size_of::<$Struct>());
        $(
            let member = unsafe { std::ptr::addr_of!((*start).$member) };
            let _in_c = stringify!($member);
            $(let _in_c = $in_c;)?
            println!(concat!($name, ".{} {} {}"), _in_c, member as usize - start as usize, size_of_target(member));
        )*
    };
}

fn main() {
    layout!(Draw as "foredraw_draw", end "": size, vertex_count, triangle_count, name, indices, positions,
            stream_count, streams, cluster_count, cluster_offsets);
    layout!(Value as "foredraw_value", end "": integer, number, text);
    layout!(OptionRow as "foredraw_option", end "": name, doc, unit, kind as "type", choice_count, choices, initial,
            least, most);
    layout!(Answer as "foredraw_answer", end ".vertex_from": values, count);
    layout!(Plugin as "foredraw_plugin", end ".acts_on": size, kind, name, summary, reference, needs, provides, breaks,
            options, metrics, option_count, metric_count, runs_on_many_threads, user, run);
    layout!(Module as "foredraw_module", end "": size, major, minor, plugin_count, vendor, version, plugins);
    println!("FOREDRAW_TRIANGLE_ORDERER {}", ORDERER);
    println!("FOREDRAW_NUMBER {}", NUMBER);
}
