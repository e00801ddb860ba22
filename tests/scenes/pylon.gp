# A lattice tower: free lines without faces, haloed (Franklin and Akman 1987) so that one sees which bar is in front.
set title "haloed lines, a lattice tower"
set paper 210,297
set view 74,28
set hidden3d halo
set halo 0.8
splot 'pylon.obj'
