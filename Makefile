# The short way in. What each word means is in CMakePresets.json; what it needs, in packages/.
MODEL ?= benchmarks/corpus/animated/kaykit_knight.glb
INSTANCES ?= 10000
SEED ?= 1
DEMO := build/demo
FOREDRAW := build/release/hosts/cli/foredraw

TESTING := test quick long-test asan tsan fuzz ci-core ci-platforms ci-pictures

.PHONY: help demo build $(TESTING) $(TESTING:%=%-phases) farm-test clang same-bytes bench real-files city level-walk vertex-orders overdraw-error han-sander-2016 particle-trim back-sides simplifiers merge-instances packages clean
help:
	@echo 'make demo     build the program, make one model cheaper to draw, show the figures (MODEL=file.glb for yours)'
	@echo 'make build    build the program: $(FOREDRAW)'
	@echo 'make test     build everything, run the tests; make quick: those for use between edits'
	@echo 'make ci-core, make ci-platforms, make ci-pictures  the parts of continuous integration: docs/guides/building.md'
	@echo 'make long-test  the checks of minutes: millions of triangles, hundreds of views, slow plugins on the corpus, make fuzz'
	@echo 'make farm-test  a folder in parts by Slurm and by GNU parallel, both installed first; Slurm is started by the test alone'
	@echo 'make clang    build the program with clang, not optimised: whether the other compiler takes it'
	@echo 'make bench    build the benchmarks, in build/release/benchmarks: foredraw-bench, the program with the peers beside'
	@echo '              our plugins, techniques/techniques-bench, which times both sides, and vertex_order/vertex-order-bench'
	@echo 'make vertex-orders  run the last one, and make docs/results/vertex-orders.md of its figures'
	@echo 'make overdraw-error  how far evaluators of overdraw are from the truth, and docs/results/overdraw-error.md of it'
	@echo 'make han-sander-2016  the experiment of that paper on our animated models, and docs/results/han-sander-2016.md of it'
	@echo 'make particle-trim  how small trimmed sprites are, and in which time, and docs/results/particle-trim.md of it'
	@echo 'make back-sides  the plots of docs/guides/sides.md, docs/guides/hidden.md and docs/guides/draw-sequence.md, of their figures'
	@echo 'make simplifiers  how far all simplifiers depart, and in which time, and docs/results/simplifiers.md of it:'
	@echo '              MESHOPTIMIZER="folder of its sources" FILES="mesh mesh"'
	@echo 'make merge-instances  draw calls, bytes and times of merged instances beside other ways, for 10,000 to 1,000,000 of them'
	@echo 'make real-files  what becomes of the models below some folders: FILES="folder folder"'
	@echo 'make city     a city of about 10,000 placed primitives: build/city.glb (INSTANCES=100000 SEED=2 for another one)'
	@echo 'make level-walk  cameras walk through a city, a field and a building: build/walk/, with a page for each'
	@echo 'make asan     run the tests with memory and undefined behaviour watched; make tsan: with threads watched'
	@echo 'make fuzz     let each fuzz target run for a minute (clang)'
	@echo 'make packages  Debian packages and a Python wheel, in build/release/packages; the same bytes from the same sources'
	@echo 'make clean    remove build/'

demo: build
	@mkdir -p $(DEMO)
	$(FOREDRAW) optimize $(MODEL) -o $(DEMO)/$(notdir $(MODEL)) --report $(DEMO)/report.json --html $(DEMO)/report.html
	@echo 'The model that was made: $(DEMO)/$(notdir $(MODEL)); all figures: $(DEMO)/report.json; a page of them: $(DEMO)/report.html'

build:
	packages/install build
	cmake --preset release && cmake --build --preset release --target foredraw

# These run in phases, which are in <target>-phases, and end with a table of the seconds of each.
$(TESTING):
	@.ci/timed $@ $(MAKE) --no-print-directory $@-phases

# $(call test_in_phases,preset,packages,test preset if it is another). SMOKE=1: without the cases of minutes.
define test_in_phases
	.ci/timed install packages/install build test import $(2)
	.ci/timed configure cmake --preset $(1)
	.ci/timed build cmake --build --preset $(1)
	.ci/timed tests ctest --preset $(or $(3),$(1)) $(if $(SMOKE),-LE '^long$$') --output-junit $(CURDIR)/build/times/$@.xml
endef

test-phases:
	$(call test_in_phases,release-tests)
asan-phases tsan-phases: %-phases:
	$(call test_in_phases,$*)
fuzz-phases:
	$(call test_in_phases,fuzz,fuzz)
quick-phases ci-platforms-phases ci-pictures-phases: %-phases:
	$(call test_in_phases,release-tests,,$*)
long-test-phases: fuzz
	$(call test_in_phases,release-tests,,long-test)
ci-core-phases:
	$(call test_in_phases,release-tests,,ci-core)
	.ci/timed clang $(MAKE) --no-print-directory clang
	.ci/timed same-bytes $(MAKE) --no-print-directory same-bytes

farm-test:
	packages/install build farm
	cmake --preset release && cmake --build --preset release --target foredraw
	tests/farm/run parallel $(FOREDRAW) build/farm/parallel
	tests/farm/run slurm $(FOREDRAW) build/farm/slurm

clang:
	packages/install build clang
	cmake --preset clang && cmake --build --preset clang --target foredraw

# What both compilers' programs make of a model.
same-bytes:
	for build in release clang; do \
	  build/$$build/hosts/cli/foredraw optimize benchmarks/corpus/static/spot.glb -o build/$$build/spot.glb \
	    -p "weld, second-depth, quadric-collapse, levels, lookahead, vertex-fetch" --with vertex-cache | tail -1 || exit 1; \
	done
	cmp build/release/spot.glb build/clang/spot.glb

bench:
	packages/install build bench
	cmake --preset release -DFOREDRAW_BUILD_BENCHMARKS=ON && cmake --build --preset release --target foredraw-bench techniques-bench vertex-order-bench layers-bench occlusion-order-bench overdraw-raster-bench overdraw-error-bench han-sander-2016-bench particle-trim-bench merge-instances-bench draco-reading-bench reading-bench progressive-mesh-bench examples-bench lod-select-bench vertex-pack-bench

vertex-orders: bench
	build/release/benchmarks/vertex_order/vertex-order-bench --tsv=benchmarks/vertex_order/figures.tsv
	benchmarks/vertex_order/vertex_orders_page.py benchmarks/vertex_order/figures.tsv

overdraw-error: bench
	build/release/benchmarks/overdraw_error/overdraw-error-bench --tsv=benchmarks/overdraw_error/figures.tsv
	benchmarks/overdraw_error/overdraw_error_page.py benchmarks/overdraw_error/figures.tsv

han-sander-2016: bench
	build/release/benchmarks/han_sander_2016/han-sander-2016-bench --tsv=benchmarks/han_sander_2016/figures.tsv --motions=2 --sweeps=cesium_man_notex
	benchmarks/han_sander_2016/han_sander_2016_page.py benchmarks/han_sander_2016/figures.tsv

particle-trim: bench
	build/release/benchmarks/particle_trim/particle-trim-bench --tsv=benchmarks/particle_trim/figures.tsv
	benchmarks/particle_trim/particle_trim_page.py benchmarks/particle_trim/figures.tsv

back-sides:
	benchmarks/back_sides/back_sides_page.py benchmarks/back_sides/figures.tsv

# The peer's sources lie elsewhere, as do most meshes. CGAL's licence holds for this build, which is therefore apart.
simplifiers:
	packages/install build bench cgal
	cmake --preset release -B build/simplifiers -DFOREDRAW_BUILD_BENCHMARKS=ON -DFOREDRAW_MESHOPTIMIZER=$(MESHOPTIMIZER) -DFOREDRAW_CGAL_COLLAPSE=ON
	cmake --build build/simplifiers --target simplifiers-bench
	build/simplifiers/benchmarks/simplification/simplifiers-bench --most-energy=14000 --tsv=benchmarks/simplification/figures.tsv $(FILES)
	benchmarks/simplification/simplifiers_page.py benchmarks/simplification/figures.tsv

merge-instances: INSTANCES = 10000,100000,1000000
merge-instances: bench
	build/release/benchmarks/merge_instances/merge-instances-bench --instances=$(INSTANCES) --tsv=benchmarks/merge_instances/figures.tsv

VIEWER = build/real_files_viewer
real-files: build
	@mkdir -p $(VIEWER) && cp -pu benchmarks/real_files/viewer/* $(VIEWER) && (cd $(VIEWER) && ./install) || true
	benchmarks/real_files/real_files.py $(FOREDRAW) $(FILES) --list build/real-files.tsv --kept build/real-files \
	  $(addprefix --validator ,$(wildcard build/release/tests/validator)) \
	  $$([ ! -d $(VIEWER)/node_modules/three ] || echo --viewer $(VIEWER))

city:
	packages/install build bench
	cmake --preset release -DFOREDRAW_BUILD_BENCHMARKS=ON && cmake --build --preset release --target merge-instances-scenes
	build/release/benchmarks/merge_instances/merge-instances-scenes --output=build/city.glb --instances=$(INSTANCES) --seed=$(SEED)

level-walk:
	packages/install build bench
	cmake --preset release -DFOREDRAW_BUILD_BENCHMARKS=ON && cmake --build --preset release --target foredraw level-walk-scenes
	@mkdir -p build/walk
	for scene in city field building; do \
	  build/release/benchmarks/level_walk/level-walk-scenes --scene=$$scene --output=build/walk/$$scene.glb && \
	  $(FOREDRAW) optimize build/walk/$$scene.glb -o build/walk/$$scene.lod.glb -p benchmarks/level_walk/levels.toml && \
	  $(FOREDRAW) optimize build/walk/$$scene.lod.glb -o build/walk/$$scene.out.glb -p benchmarks/level_walk/walk.toml --html build/walk/$$scene.html || exit 1; \
	done

packages: export SOURCE_DATE_EPOCH ?= $(shell git log -1 --format=%ct 2>/dev/null || echo 0)
packages:
	packages/install build import package
	cmake --preset release && cmake --build --preset release
	cd build/release && cpack -G DEB
	hosts/python/make_wheel build/release/packages

clean:
	rm -rf build
