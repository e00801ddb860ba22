#!/bin/sh
# Where drawings go: the same file however it is written, and the old one until the new one is whole.
. "${0%/*}/lib.sh"

# One file of text is written while it is drawn, several from memory.
one_output_is_as_several() {
    for scene in smooth ridgeline temple shadows; do
        for suffix in seg svg plt gcode; do
            ridgeline plot "$scenes/$scene.gp" -o one.$suffix
            ridgeline plot "$scenes/$scene.gp" -o two.$suffix -o also.svg
            cmp one.$suffix two.$suffix
        done
    done
    for pen in 2 'silhouette 3'; do
        ridgeline plot "$scenes/temple.gp" --set "set pen $pen" -o one.svg
        ridgeline plot "$scenes/temple.gp" --set "set pen $pen" -o two.svg -o also.seg
        cmp one.svg two.svg
        grep -q 'label="pen [23]"' one.svg
    done
    printf 'set isosamples 8\nsplot x*y; splot x+y; replot\n' >pages.gp
    ridgeline plot pages.gp -o p.svg
    ridgeline plot pages.gp -o q.svg -o r.seg
    for page in '' -2 -3; do cmp p$page.svg q$page.svg; done
}

what_fails_changes_nothing() {
    echo old >a-2.svg
    printf 'set isosamples 8\nsplot x*y; set zrange [1:1]; splot x*y\n' >bad.gp
    expect_status 2 ridgeline plot bad.gp -o a.svg 2>err
    [ "$(cat a-2.svg)" = old ]
    grep -q '</svg>' a.svg
    [ "$(ls)" = "$(printf 'a-2.svg\na.svg\nbad.gp\nerr')" ]
}

# At any time: then there is the old file or the new one, and nothing else.
a_killed_program_leaves_the_old_file() {
    printf 'set isosamples 300\nsplot rand(0)\n' >long.gp
    ridgeline plot long.gp -o new.seg
    for time in 0.001 0.005 0.01 0.015 0.02 0.03; do
        echo old >a.seg
        timeout -s KILL $time "$RIDGELINE" plot long.gp -o a.seg || true
        [ "$(cat a.seg)" = old ] || cmp a.seg new.seg
    done
    [ "$(ls)" = "$(printf 'a.seg\nlong.gp\nnew.seg')" ]
}

what_is_no_plain_file_is_written_to() {
    small_scene
    ridgeline plot small.gp -o want.seg
    mkfifo pipe.seg
    cat pipe.seg >got.seg &
    ridgeline plot small.gp -o pipe.seg
    wait
    cmp want.seg got.seg
    [ -p pipe.seg ]
    ln -s /dev/stdout out.seg
    ridgeline plot small.gp -o out.seg | cmp - want.seg
    ln -s there.seg link.seg
    ridgeline plot small.gp -o link.seg
    cmp want.seg there.seg
    [ -L link.seg ]
}

a_folder_in_which_nothing_can_be_made() {
    [ "$(id -u)" -ne 0 ] || return 0 # who may do anything
    small_scene
    ridgeline plot small.gp -o want.seg
    mkdir closed
    echo "a much longer drawing" >closed/a.seg
    chmod 555 closed
    ridgeline plot small.gp -o closed/a.seg
    expect_status 1 ridgeline plot small.gp -o closed/b.seg 2>err
    chmod 755 closed
    expect_text err 'closed/b.seg: Permission denied'
    cmp want.seg closed/a.seg
}

no_drawing_takes_the_place_of_another_or_the_scene() {
    printf 'set isosamples 8\nsplot x*y; splot x+y\n' >pages.gp
    expect_status 1 ridgeline plot pages.gp -o q.svg -o q-2.svg 2>err
    expect_text err 'page 2 of q.svg would be q-2.svg, which is an output itself'
    cmp q.svg q-2.svg
    small_scene
    cp small.gp small.seg
    ln small.seg other.seg
    for name in small.seg ./small.seg other.seg; do
        expect_status 2 ridgeline plot small.seg -o fine.svg -o $name 2>err
        expect_text err "$name: is the scene itself"
    done
    cmp small.gp small.seg
    [ ! -e fine.svg ]
}

run_tests one_output_is_as_several no_drawing_takes_the_place_of_another_or_the_scene what_fails_changes_nothing a_killed_program_leaves_the_old_file \
    what_is_no_plain_file_is_written_to a_folder_in_which_nothing_can_be_made
