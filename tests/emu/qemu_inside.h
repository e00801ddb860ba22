/* qemu_inside.h - what scope.so asks of the qemu-system-arm that loads it. Debian's QEMU 7.2 has no headers for
 * plugins, and the public interface has neither virtual time nor GPIO lines nor devices; so both the interface and the
 * internals used (which its binary exports) are declared here by hand. */
#ifndef QEMU_INSIDE_H
#define QEMU_INSIDE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define CLOCK_VIRTUAL 1

/* The public interface, version 1. */
typedef uint64_t qemu_plugin_id_t;
struct qemu_plugin_tb;
struct qemu_plugin_insn;
struct qemu_info;
enum { PLUGIN_NO_REGISTERS, PLUGIN_MEMORY_WRITTEN = 2 };
extern bool qemu_plugin_mem_is_store(uint32_t info); /* 7.2 calls back for reads as well */
extern size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb *);
extern struct qemu_plugin_insn *qemu_plugin_tb_get_insn(const struct qemu_plugin_tb *, size_t);
extern void qemu_plugin_register_vcpu_mem_cb(struct qemu_plugin_insn *, void (*)(unsigned, uint32_t, uint64_t, void *),
                                             int flags, int access, void *);
extern void qemu_plugin_register_vcpu_tb_trans_cb(qemu_plugin_id_t,
                                                  void (*)(qemu_plugin_id_t, struct qemu_plugin_tb *));
extern void qemu_plugin_register_vcpu_init_cb(qemu_plugin_id_t, void (*)(qemu_plugin_id_t, unsigned));
extern void qemu_plugin_register_atexit_cb(qemu_plugin_id_t, void (*)(qemu_plugin_id_t, void *), void *);

/* Internals of 7.2. */
typedef void *qemu_irq;
extern int64_t qemu_clock_get_ns(int type);
extern void *object_resolve_path(const char *path, bool *ambiguous);
extern qemu_irq qemu_allocate_irq(void (*handler)(void *, int, int), void *opaque, int n);
extern qemu_irq qdev_intercept_gpio_out(void *dev, qemu_irq icpt, const char *name, int n);
extern qemu_irq qdev_get_gpio_in(void *dev, int n);
extern void qemu_set_irq(qemu_irq irq, int level);
extern void timer_init_full(void *timer, void *list, int type, int scale, int attrs, void (*cb)(void *), void *opaque);
extern void timer_mod(void *timer, int64_t expire);
extern void timer_del(void *timer);
extern void qemu_mutex_lock_iothread_impl(const char *file, int line);
extern void qemu_mutex_unlock_iothread(void);
extern bool qemu_mutex_iothread_locked(void);
extern void *qemu_chr_find(const char *name);
extern int qemu_chr_be_can_write(void *chardev);
extern void qemu_chr_be_write(void *chardev, const uint8_t *buf, int len);
extern void qemu_system_shutdown_request(int cause);
extern void *qemu_get_cpu(int index);
extern int cpu_memory_rw_debug(void *cpu, uint64_t at, void *buf, uint64_t bytes, bool write);

typedef struct memory_ops {
    uint64_t (*read)(void *opaque, uint64_t at, unsigned bytes);
    void (*write)(void *opaque, uint64_t at, uint64_t value, unsigned bytes);
    void *with_attributes[2];
    int endian; /* 2: little */
    struct {
        unsigned least, most;
        bool unaligned;
        void *accepts;
    } valid;
    struct {
        unsigned least, most;
        bool unaligned;
    } impl;
} memory_ops_t;
typedef struct memory_region {
    _Alignas(16) unsigned char opaque[1024]; /* a MemoryRegion, which is smaller */
} memory_region_t;
extern void *get_system_memory(void);
extern void memory_region_init_io(memory_region_t *region, void *owner, const memory_ops_t *ops, void *opaque,
                                  const char *name, uint64_t bytes);
extern void memory_region_add_subregion_overlap(void *to, uint64_t at, memory_region_t *region, int priority);

/* As a debugger reads and writes it, flash too. */
static inline bool qemu_memory(uint64_t at, void *buf, uint64_t bytes, bool write) {
    return cpu_memory_rw_debug(qemu_get_cpu(0), at, buf, bytes, write) == 0;
}

#endif
