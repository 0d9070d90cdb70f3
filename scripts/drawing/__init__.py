"""Pictures of a run, one module per picture; scripts/draw_run.py calls them."""
