# boards.mk - what a board is to the compiler: its core, and the capacities (src/config.h) that its memory allows.
BOARDS := rp2040 lm3s6965 nrf51

CPU_rp2040   := -mcpu=cortex-m0plus
CPU_lm3s6965 := -mcpu=cortex-m3
CPU_nrf51    := -mcpu=cortex-m0

OPT_rp2040   := -O2
OPT_lm3s6965 := -O2
OPT_nrf51    := -Os
# What runs once a command is small rather than fast: 256 KB of flash are nearly full.
$(patsubst %.c,$(BUILDDIR)/firmware/lm3s6965/%.o,$(filter-out src/lang/eval.c src/lang/arith.c,$(wildcard src/lang/*.c)) \
    $(wildcard src/app/*.c src/hidden/halo*.c src/hidden/shad*.c src/hidden/triangulate.c src/hidden/convex.c \
    src/scene/solid*.c src/scene/obj*.c src/scene/data*.c src/scene/profiles*.c src/view/solid*.c src/view/camera*.c \
    src/view/flat*.c src/view/auto*.c src/poly/*.c src/path/chain.c src/path/loop.c src/path/emit.c)): OPT_lm3s6965 := -Os

CONFIG_rp2040 := CONFIG_LINE_MAX=1024 CONFIG_LOAD_DEPTH=0 CONFIG_READ_CHUNK=16 CONFIG_PLOT_ITEMS=4 CONFIG_DATA_COLUMNS=8 \
    CONFIG_SYMBOLS=64 CONFIG_POOL=2048 CONFIG_STACK=256 CONFIG_CALLS=64 CONFIG_PLOT_CODE=1024 CONFIG_JOINS=8 CONFIG_NAME_MAX=80 \
    CONFIG_JOURNAL=1024 CONFIG_BOARD_BYTES=212992 CONFIG_MOTION_BLOCKS=512 CONFIG_MOTION_PIECES=64
CONFIG_lm3s6965 := CONFIG_LINE_MAX=512 CONFIG_LOAD_DEPTH=0 CONFIG_READ_CHUNK=16 CONFIG_PLOT_ITEMS=2 CONFIG_DATA_COLUMNS=8 \
    CONFIG_SYMBOLS=32 CONFIG_POOL=1024 CONFIG_STACK=64 CONFIG_CALLS=16 CONFIG_PLOT_CODE=512 CONFIG_JOINS=4 CONFIG_NAME_MAX=64 \
    CONFIG_TYPED=128 CONFIG_JOURNAL=256 CONFIG_BOARD_BYTES=36864 CONFIG_MOTION_BLOCKS=128 CONFIG_MOTION_PIECES=32 CONFIG_PULSE_NS=4000
CONFIG_nrf51 := CONFIG_LINE_MAX=160 CONFIG_LOAD_DEPTH=0 CONFIG_READ_CHUNK=16 CONFIG_PLOT_ITEMS=1 CONFIG_DATA_COLUMNS=4 \
    CONFIG_SYMBOLS=12 CONFIG_POOL=256 CONFIG_STACK=24 CONFIG_CALLS=4 CONFIG_PLOT_CODE=128 CONFIG_JOINS=1 CONFIG_NAME_MAX=16 \
    CONFIG_NESTING=16 CONFIG_TYPED=32 CONFIG_JOURNAL=32 CONFIG_BOARD_BYTES=3584 CONFIG_MOTION_BLOCKS=16 CONFIG_MOTION_PIECES=8 \
    CONFIG_PULSE_NS=10000 CONFIG_DIR_SETUP_NS=5000
