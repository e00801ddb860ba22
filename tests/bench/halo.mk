# `make bench-halo`: haloed lines, the paper's table and figure.
$(BUILDDIR)/bench/bench_halo: $(BUILDDIR)/obj/tests/bench/bench_halo.o $(BUILDDIR)/liboracle.a $(BUILDDIR)/libcore.a
	@mkdir -p $(@D)
	$(call say,LD,$@)
	$(Q)$(CC) $(LDFLAGS) $^ -lm -o $@
bench-halo: $(BUILDDIR)/bench/bench_halo ## haloed lines: CUT and DRAW, ns per edge
	$(Q)$<
bench: bench-halo
.PHONY: bench-halo
