# `make bench-clip`: the polygon clipper beside the libraries that are installed. Part of `make bench`.
.PHONY: bench-clip
$(BUILDDIR)/bench/bench_clip: $(BUILDDIR)/obj/tests/bench/bench_clip.o $(BUILDDIR)/libcore.a
	@mkdir -p $(@D)
	$(call say,LD,$@)
	$(Q)$(CC) $(LDFLAGS) $^ -lm -o $@
# A peer that is not installed is not built, and its column stays empty.
$(BUILDDIR)/bench/clipper1: tests/bench/peers/clipper1.cc tests/bench/stars.h
	@mkdir -p $(@D)
	$(Q)if test -f /usr/include/polyclipping/clipper.hpp; then g++ -w -O2 -I. $< -lpolyclipping -o $@; fi
$(BUILDDIR)/bench/boost_clip: tests/bench/peers/boost_clip.cc tests/bench/stars.h
	@mkdir -p $(@D)
	$(Q)if test -f /usr/include/boost/geometry.hpp; then g++ -w -O2 -I. $< -o $@; fi

bench-clip: $(BUILDDIR)/bench/bench_clip $(BUILDDIR)/bench/clipper1 $(BUILDDIR)/bench/boost_clip ## ms for intersections of stars, beside Clipper and Boost
	$(Q)sh tests/bench/clip.sh $(BUILDDIR)
bench: bench-clip
