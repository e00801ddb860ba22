quit foo
