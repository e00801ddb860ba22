# `make bench-area`: what the polygon area sort costs; part of `make bench`.
$(BUILDDIR)/bench/bench_area: $(BUILDDIR)/obj/tests/bench/bench_area.o $(BUILDDIR)/liboracle.a $(BUILDDIR)/libcore.a
	@mkdir -p $(@D)
	$(call say,LD,$@)
	$(Q)$(CC) $(LDFLAGS) $^ $(TEST_LIBS) -lm -o $@

.PHONY: bench-area
bench-area: $(BUILDDIR)/bench/bench_area ## ms for the area sort, and how its work grows with and without subdivision
	$(Q)$<
bench: bench-area
