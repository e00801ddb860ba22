# `make bench-solids`: what solids cost; part of `make bench`.
$(BUILDDIR)/bench/bench_solids: $(BUILDDIR)/obj/tests/bench/bench_solids.o $(BUILDDIR)/obj/tests/bench/brute_convex.o $(BUILDDIR)/liboracle.a $(BUILDDIR)/libcore.a
	@mkdir -p $(@D)
	$(call say,LD,$@)
	$(Q)$(CC) $(LDFLAGS) $^ $(TEST_LIBS) -lm -o $@

.PHONY: bench-solids
bench-solids: $(BUILDDIR)/bench/bench_solids ## ms for k x k cubes and bodies of triangles, parse excluded
	$(Q)$< 2 7 14 28 56
bench: bench-solids
