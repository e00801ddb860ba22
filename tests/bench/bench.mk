# `make bench`: our surfaces beside the peers that are installed.
BENCH := $(BUILDDIR)/bench/bench_surfaces $(BUILDDIR)/bench/cpu_time $(BUILDDIR)/bench/heights

$(BUILDDIR)/bench/bench_surfaces: $(BUILDDIR)/obj/tests/bench/bench_surfaces.o $(BUILDDIR)/libcore.a
	@mkdir -p $(@D)
	$(call say,LD,$@)
	$(Q)$(CC) $(LDFLAGS) $^ -lm -o $@
$(BUILDDIR)/bench/cpu_time $(BUILDDIR)/bench/heights: $(BUILDDIR)/bench/%: $(BUILDDIR)/obj/tests/bench/%.o
	@mkdir -p $(@D)
	$(call say,LD,$@)
	$(Q)$(CC) $(LDFLAGS) $^ -lm -o $@
# A peer that is not installed is not built, and its column stays empty.
$(BUILDDIR)/bench/plmesh: tests/bench/peers/plmesh.c tests/bench/table1.h
	@mkdir -p $(@D)
	$(Q)if pkg-config --exists plplot 2>/dev/null; then \
	    $(CC) $(CPPFLAGS) $(OPT) $$(pkg-config --cflags plplot) $< $$(pkg-config --libs plplot) -lm -o $@; fi

bench: host $(BENCH) $(BUILDDIR)/bench/plmesh ## ns per facet beside gnuplot hidden3d and PLplot plmesh (SIZES="60 200")
	$(Q)sh tests/bench/bench.sh $(BUILDDIR)
