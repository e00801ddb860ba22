# `make report`: the numbers report, docs/report. Each program writes data and figures, and its section of the README.
REPORT_DIR ?= docs/report
REPORT_LIB := $(patsubst %.c,$(BUILDDIR)/obj/%.o,$(filter-out tests/report/report_%.c,$(wildcard tests/report/*.c)) \
    tests/emu/bare/formats.c)
REPORTS := $(patsubst tests/report/%.c,$(BUILDDIR)/report/%,$(wildcard tests/report/report_*.c))
# lattice.c stands before these functions of src/.
REPORT_WRAP := $(addprefix -Wl$(comma)--wrap=,chart_row horizons_clip windows_insert)

$(BUILDDIR)/report/%: $(BUILDDIR)/obj/tests/report/%.o $(REPORT_LIB) $(BUILDDIR)/liboracle.a $(BUILDDIR)/libhost.a $(BUILDDIR)/libcore.a
	@mkdir -p $(@D)
	$(call say,LD,$@)
	$(Q)$(CC) $(LDFLAGS) $(REPORT_WRAP) $^ $(HOST_LIBS) $(shell pkg-config --libs cairo) $(TEST_LIBS) -o $@

# Solids on coarser lattices: only these two sources know how fine it is. 2^14 units of the scene are a step.
SOLID_BITS := 14 16 18 22 28
SOLID_BITS_PROGRAMS := $(SOLID_BITS:%=$(BUILDDIR)/report/solid_bits_%)
SOLID_BITS_SRC := tests/report/tools/solid_bits.c src/scene/solid.c src/view/solid_map.c
$(BUILDDIR)/report/solid_bits_%: $(SOLID_BITS_SRC) $(REPORT_LIB) $(BUILDDIR)/liboracle.a $(BUILDDIR)/libhost.a $(BUILDDIR)/libcore.a
	@mkdir -p $(@D)
	$(call say,CC,$@)
	$(Q)$(CC) $(CPPFLAGS) $(CFLAGS) -DSOLID_BITS=$* $(SOLID_BITS_SRC) $(LDFLAGS) $(REPORT_WRAP) $(filter-out %.c,$^) $(HOST_LIBS) \
	    $(shell pkg-config --libs cairo) $(TEST_LIBS) -o $@

report: ## install what is missing, write docs/report: speed against error, hard cases, the papers' experiments
	$(Q)sh .ci/deps.sh host test firmware emu check
	+$(Q)$(again) report-run
# SECTION=solids: that section alone (report_solids.c), put into the README that is there.
SECTION_NEEDS = $(if $(filter bits,$(SECTION)),$(SOLID_BITS_PROGRAMS),$(BUILDDIR)/report/report_$(SECTION))
report-run: $(if $(SECTION),$(SECTION_NEEDS),host $(REPORTS) $(BARE_COUNTS) $(SOLID_BITS_PROGRAMS))
	$(Q)CROSS=$(CROSS) sh tests/report/report.sh $(BUILDDIR) $(REPORT_DIR) $(SECTION)
# Twice, from one build: what is no time must be the same. Leaves the report alone.
report-twice: ## run the report twice into build/, and compare: the same numbers from the same commit
	$(Q)sh .ci/deps.sh host test firmware emu check
	+$(Q)$(again) REPORT_DIR=$(BUILDDIR)/report-1 report-run
	+$(Q)$(again) REPORT_DIR=$(BUILDDIR)/report-2 report-run
	$(Q)sh tests/report/twice.sh $(BUILDDIR)/report-1 $(BUILDDIR)/report-2
.PHONY: report report-run report-twice
# tests/cli/test_report.sh runs it.
test-run test-cli: $(addprefix $(BUILDDIR)/report/,report_error report_solids solid_bits_28)

SOAK_MINUTES ?= 10
SOAK_TESTS := $(addprefix $(BUILDDIR)/tests/property/,test_metamorphic test_differential test_solid_laws test_perimeter_random \
    test_holes_random test_horizon_random test_several_random test_awkward_random test_extreme_random test_folded_random test_strips \
    test_convex_random test_area_random test_body_random test_touching_random test_polygons_random test_clear_random test_light_random test_seams_random test_patch_random \
    test_once_random test_shaded_random test_halo_random test_halo_scene test_clip_random test_clip_families test_tone_memory test_small_memory \
    test_motion_random test_path_random)
soak: $(SOAK_TESTS) $(BARE_SAME) ## random scenes and laws against the reference, new seeds every round, for SOAK_MINUTES (10)
	$(Q)BUILDDIR=$(BUILDDIR) sh tests/report/soak.sh $(SOAK_MINUTES) $(SOAK_TESTS) tests/emu/test_same.sh
.PHONY: soak
$(BUILDDIR)/obj/tests/report/sheet.o $(BUILDDIR)/obj/tests/report/report_clipper.o: CPPFLAGS += $(HOST_CFLAGS)
