# Draws lab 6.
