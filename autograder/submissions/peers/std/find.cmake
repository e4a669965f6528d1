set(PEER_FOUND ON)  # comes with the compiler
